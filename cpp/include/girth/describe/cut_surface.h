// The members of what girth/cut_surface.h finds.
#pragma once

#include "girth/cut_surface.h"
#include "girth/describe/description.h"

namespace girth {

/// The members of a curve's side.
constexpr auto describe(Members<CurveSide>) {
  return described<CurveSide>(member("area", &CurveSide::area),
                              member("volume", &CurveSide::volume));
}

/// The members of a part's measures.
constexpr auto describe(Members<PartMeasures>) {
  return described<PartMeasures>(
      member("area", &PartMeasures::area), member("volume", &PartMeasures::volume),
      member("genus", &PartMeasures::genus), member("boundaries", &PartMeasures::boundaries));
}

}  // namespace girth
