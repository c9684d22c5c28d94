#include "solver/marched/marched_girth.h"

#include "mesh/neighbours.h"

namespace girth {

namespace {

/// How many groups the accepted neighbours of a vertex form around it.
int groupsAround(const geodesic::FastMarching& march, const SurfaceMesh& mesh, Index vertex) {
  int groups = 0;
  bool first = false, before = false, started = false;
  forEachNeighbour(mesh, Vertex(vertex), [&](Index neighbour) {
    const bool accepted = march.accepted(neighbour);
    if (!started) first = accepted;
    if (accepted && !(started && before)) ++groups;
    started = true;
    before = accepted;
  });
  // Round an inner vertex, the last neighbour stands beside the first.
  if (groups > 1 && first && before && !mesh.isBoundary(Vertex(vertex))) --groups;
  return groups;
}

}  // namespace

GirthValue marchedGirth(geodesic::FastMarching& march, const SurfaceMesh& mesh, Index vertex,
                        const ExecutionContext& context) {
  GirthValue value{0, LoopKind::Antipodal};
  march.run(vertex, [&](Index reached, double distance) {
    value.length = 2 * distance;
    if (groupsAround(march, mesh, reached) < 2) return !context.cancelled();
    value.kind = LoopKind::Loop;
    return false;
  });
  return value;
}

}  // namespace girth
