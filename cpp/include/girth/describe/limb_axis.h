// The members of what girth/limb_axis.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/limb_axis.h"

namespace girth {

/// The members of a loop of an axis.
constexpr auto describe(Members<AxisStation>) {
  return described<AxisStation>(
      member("distance", &AxisStation::distance), member("along", &AxisStation::along),
      member("girth", &AxisStation::girth), member("area", &AxisStation::area),
      member("centre", &AxisStation::centre), curve("points", &AxisStation::points));
}

}  // namespace girth
