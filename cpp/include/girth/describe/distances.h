// The members of what girth/distances.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/distances.h"

namespace girth {

/// The members of two points.
constexpr auto describe(Members<PointPair>) {
  return described<PointPair>(needed("start", &PointPair::start), needed("end", &PointPair::end));
}

/// The members of options.
constexpr auto describe(Members<DistancesOptions>) {
  return described<DistancesOptions>(needed("pairs", &DistancesOptions::pairs),
                                     member("paths", &DistancesOptions::paths));
}

/// The members of a distance.
constexpr auto describe(Members<Distance>) {
  return described<Distance>(member("start", &Distance::start), member("end", &Distance::end),
                             member("length", &Distance::length),
                             member("straight", &Distance::straight),
                             curve("points", &Distance::points));
}

/// The members of several distances.
constexpr auto describe(Members<Distances>) {
  return described<Distances>(member("distances", &Distances::distances));
}

}  // namespace girth
