// The rings that level curves of a height make before the main part of what is higher: their
// lengths, and the girth along them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/unreached_rest.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// Lengths of the rings at some levels, in rising order; the height is linear within faces. A ring
/// bounds what is lower than its level. `leaves`: of unreachedRest. O(n log m + all crossings).
std::vector<double> ringLengths(const SurfaceMesh& mesh, std::span<const double> heights,
                                std::span<const double> leaves, std::span<const double> levels);

/// The part of a ring in one face: straight, from one of its sides to another.
struct RingSegment {
  Face face;
  SurfacePoint from, to;
};

/// The segments of the ring at a level.
std::vector<RingSegment> ringSegments(const SurfaceMesh& mesh, std::span<const double> heights,
                                      std::span<const double> leaves, double level);

/// A point of a ring.
struct RingPoint {
  double girth{0};
  SurfacePoint place;
};

/// The girth along one ring.
struct RingGirth {
  double length{0};  ///< the length of the ring
  double median{0};  ///< by length; NaN where no part has a value
  /// Points in rising order of their girths: the least of all, then the middles of equal shares of
  /// the ring's length. Empty where no part has a value.
  std::vector<RingPoint> points;
  /// The two points with the girth of the middle share that differ most in what lies around
  /// them; empty where no part has a value.
  std::vector<RingPoint> middles;
};

/// The girth along the rings at some levels, in rising order, each in a number of shares. `girth`:
/// of the vertices, NaN where there is none; between them as `interpolated` with 2.
std::vector<RingGirth> ringGirths(const SurfaceMesh& mesh, std::span<const double> heights,
                                  std::span<const double> leaves, std::span<const double> levels,
                                  std::span<const double> girth, std::size_t shares);

}  // namespace girth
