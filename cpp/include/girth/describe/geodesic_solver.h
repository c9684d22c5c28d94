// The members of what girth/geodesic_solver.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/geodesic_solver.h"

namespace girth {

/// The members of a path.
constexpr auto describe(Members<GeodesicPath>) {
  return described<GeodesicPath>(member("length", &GeodesicPath::length),
                                 line("points", &GeodesicPath::points));
}

}  // namespace girth
