// The members of girth/girth_profile.h.
#pragma once

#include <cmath>

#include "girth/describe/description.h"
#include "girth/girth_profile.h"

namespace girth {

/// Whether a loop goes round at a station.
inline bool hasPlace(const GirthStation& station) { return !std::isnan(station.least); }

/// The members of a station.
constexpr auto describe(Members<GirthStation>) {
  return described<GirthStation>(
      member("distance", &GirthStation::distance), member("ring", &GirthStation::ring),
      member("median", &GirthStation::median), member("least", &GirthStation::least),
      memberWhere("place", &GirthStation::place, hasPlace));
}

}  // namespace girth
