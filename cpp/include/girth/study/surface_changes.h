// Changes of a surface between two scans of one thing: other triangles, noise, humps,
// parts that have grown together. The ways in which the paper's section 5.2 puts the girth to the
// test.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth::study {

/// The surface with long thin triangles: remeshed (remesh.h) while it is drawn out `stretch`
/// times along the axis of space in which it is longest, so that triangles across that axis come
/// out shorter by as much. `stretch`: from 1, which is plain remeshing, to 100. Errors: those of
/// remesh; INVALID_OPTION.
GIRTH_EXPORT Result<SurfaceMesh> remeshedUnevenly(const SurfaceMesh& mesh, Index faces,
                                                  double stretch,
                                                  const ExecutionContext& context = {});

/// The strongest noise, in mean edge lengths.
inline constexpr double kMostNoise = 4;

/// Every vertex moved in a random direction, by a random distance of up to `amount` times the mean
/// edge length. Equal seeds always give equal surfaces. Faces may come to intersect. O(n). Errors:
/// INVALID_OPTION (amount: 0 to kMostNoise); DEGENERATE_FACE where a face loses its area.
GIRTH_EXPORT Result<SurfaceMesh> withNoise(const SurfaceMesh& mesh, double amount,
                                           std::uint64_t seed);

/// A surface whose triangles are cut into four each.
struct Subdivision {
  /// The surface.
  SurfaceMesh mesh;
  /// For each new vertex the two between which it lies; new ones are numbered after the others.
  std::vector<std::array<Vertex, 2>> between;
};

/// Cuts each triangle into four by the middles of its sides: the same surface, other triangles.
/// Vertices keep their numbers, and face f becomes 4 f to 4 f + 3. O(n). Errors:
/// DEGENERATE_FACE where a face is so thin that a quarter of it has no area.
GIRTH_EXPORT Result<Subdivision> subdivided(const SurfaceMesh& mesh);

/// How many humps are raised, and how large.
struct HumpOptions {
  /// Spread evenly over the surface.
  Index humps{8};
  /// How far each reaches along the surface, as a share of the root of the surface's area.
  double radius{0.1};
  /// How far its middle rises, as a share of the radius.
  double height{0.25};
};

/// Humps raised along the surface's normals: at the geodesic distance d from a middle by height ·
/// (1 − (d / radius)²)². Errors: INVALID_OPTION (no numbers above 0); those of GeodesicSolver;
/// DEGENERATE_FACE.
GIRTH_EXPORT Result<SurfaceMesh> withHumps(const SurfaceMesh& mesh, const HumpOptions& options = {},
                                           const ExecutionContext& context = {});

/// A tube with three sides between two faces, in whose place it comes: one handle more where both
/// are of the same component. Vertices keep their numbers. Errors: INVALID_OPTION where the faces
/// do not exist or have a vertex in common; NON_MANIFOLD_EDGE where an edge joins them already.
GIRTH_EXPORT Result<SurfaceMesh> withBridge(const SurfaceMesh& mesh, Face face1, Face face2);

/// Several of them, one after the other; faces are numbered as in the surface without bridges.
/// Without bridges: the surface itself.
GIRTH_EXPORT Result<SurfaceMesh> withBridges(const SurfaceMesh& mesh,
                                             std::vector<std::pair<Face, Face>> pairs);

/// Up to `count` pairs of faces that face each other across a gap and are far apart along the
/// surface: where parts grow together in a poor scan. Pairs come first whose way along the surface
/// is longest against the gap (at least twice as long); ends of different pairs are not near each
/// other. Looks at 300 places spread evenly. Errors: CANCELLED.
GIRTH_EXPORT Result<std::vector<std::pair<Face, Face>>> facingPlaces(
    const SurfaceMesh& mesh, std::size_t count, const ExecutionContext& context = {});

/// Tiny handles, as a poor scan has them: so many bridges (withBridge) spread evenly over the
/// surface, each between two faces a few edges apart. Vertices keep their numbers. Handles have no
/// vertices in common, nor neighbours. O(count · n). Errors: INVALID_OPTION where there is no room
/// for so many; those of withBridge.
GIRTH_EXPORT Result<SurfaceMesh> withTinyHandles(const SurfaceMesh& mesh, std::size_t count);

/// The loops round and through a tiny handle are shorter than this, in mean edge lengths, as a
/// rule.
inline constexpr double kTinyLoop = 8;

}  // namespace girth::study
