// The members of what girth/path_profile.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/path_profile.h"

namespace girth {

/// The members of a place of a path.
constexpr auto describe(Members<PathStation>) {
  return described<PathStation>(
      member("distance", &PathStation::distance), member("girth", &PathStation::girth),
      member("kind", &PathStation::kind), member("point", &PathStation::point));
}

}  // namespace girth
