// The girth along a limb, station by station.
#pragma once

#include <vector>

#include "girth/surface_point.h"

namespace girth {

/// The girth at one distance: along a ring, a closed curve that goes round the surface there.
struct GirthStation {
  /// How far along, in model units.
  double distance{0};
  /// Length of the ring itself, in model units.
  double ring{0};
  /// The median of the girth over the ring, each part of it counted by its length, in model units;
  /// NaN where no part has a value.
  double median{0};
  /// The least girth on the ring among loops that go round here, in model units; NaN where none
  /// does.
  double least{0};
  /// Where it is: a point of an edge. GirthSolver::loop gives the loop there. Only where `least` is
  /// a number.
  SurfacePoint place;
};

/// Stations in the order of their distances.
using GirthProfile = std::vector<GirthStation>;

}  // namespace girth
