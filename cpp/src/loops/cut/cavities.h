// Hollow bodies: what a cap of one of their surfaces would go through.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/surface_mesh.h"

namespace girth::loops {

/// For each component its body: the one that it is a cavity of, or itself. A cavity is a closed
/// component that lies in another one, round no third one in between, and faces the other way.
/// O(f) for each component and each whose box encloses it, of f faces.
std::vector<Index> bodiesOf(const SurfaceMesh& mesh);

/// A cap with holes: curves by their numbers.
struct HollowCap {
  std::size_t rim;                 ///< on the body
  std::vector<std::size_t> holes;  ///< on its cavities
  Vec3 normal;                     ///< normal of the plane that the cap lies in
};

/// Curves that cut bodies with their cavities.
struct HollowCurves {
  std::vector<SurfaceCurve> curves;  ///< curves that were given first
  std::vector<HollowCap> caps;
};

/// For each closed curve round a body with cavities, or in one of these, what the curve's mean
/// plane cuts out of the others. Where a curve is given that runs round the same place, it is taken
/// instead. O(n) for each curve, besides bodiesOf.
HollowCurves throughCavities(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves);

/// Triangles between the rim of a cap and its holes, each a closed polygon of vertices, the holes
/// run round the other way: of least area. Empty where there are
/// none, and where they have more than 1000 edges. `isJoined(a, b)`: whether an
/// edge joins two vertices already. O(n^3) for n vertices.
std::vector<Index> triangulatedCap(std::vector<Index> rim, std::vector<std::vector<Index>> holes,
                                   const Vec3& normal, std::span<const Vec3> places,
                                   const std::function<bool(Index, Index)>& isJoined);

}  // namespace girth::loops
