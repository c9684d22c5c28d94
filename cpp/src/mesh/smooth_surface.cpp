#include "girth/smooth_surface.h"

#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh_arrays.h"
#include "mesh/neighbours.h"
#include "mesh/vector.h"

namespace girth {

namespace {

/// Shares of the way to the neighbours' mean, there and back. The two together do not shorten a
/// shape that is longer than some four edges.
constexpr double kThere = 0.5, kBack = -0.53;

/// The mean of a vertex's neighbours; on a boundary, of the two there.
Vec3 meanAround(const SurfaceMesh& mesh, const std::vector<Vec3>& positions, Vertex vertex) {
  const bool isBoundary = mesh.isBoundary(vertex);
  Vec3 sum{0, 0, 0}, first{0, 0, 0}, last{0, 0, 0};
  double count = 0;
  forEachNeighbour(mesh, vertex, [&](Vertex neighbour) {
    last = positions[neighbour];
    if (count == 0) first = last;
    sum = sum + last;
    ++count;
  });
  return isBoundary ? 0.5 * (first + last) : (1 / count) * sum;
}

/// So many vertices are moved before it is asked whether to stop.
constexpr Index kMovedAtATime = 1 << 14;

/// Moves every vertex by a share of the way to the mean around it, unless cancelled.
void move(const SurfaceMesh& mesh, std::vector<Vec3>& positions, double share,
          const ExecutionContext& context) {
  std::vector<Vec3> moved(positions);
  for (const Vertex v : mesh.vertices()) {
    if (v % kMovedAtATime == 0 && context.cancelled()) return;
    moved[v] = positions[v] + share * (meanAround(mesh, positions, v) - positions[v]);
  }
  positions = std::move(moved);
}

}  // namespace

Result<SurfaceMesh> smoothSurface(const SurfaceMesh& mesh, Index steps,
                                  const ExecutionContext& context) {
  if (steps > kMostSmoothing) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "smoothing is 0 to " + std::to_string(kMostSmoothing) + " steps");
  }
  std::vector<Vec3> positions = positionsOf(mesh);
  for (Index step = 0; step < steps; ++step) {
    move(mesh, positions, kThere, context);
    move(mesh, positions, kBack, context);
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    if (context.onProgress && step + 1 < steps) context.onProgress((step + 1.0) / steps);
  }
  auto smooth = surfaceOf(positions, trianglesOf(mesh));
  if (!smooth) {
    Error error = smooth.error();
    error.hint = "smooth it in fewer steps";
    return error;
  }
  if (context.onProgress) context.onProgress(1);
  return smooth;
}

}  // namespace girth
