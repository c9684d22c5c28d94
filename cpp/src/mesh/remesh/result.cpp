#include "mesh/remesh/result.h"

#include <utility>
#include <vector>

namespace girth::remeshing {

Result<RemeshedSurface> resultOf(const ChangingMesh& mesh, CancellationPoll& poll,
                                 const std::function<SurfacePoint(Index)>& placeOf) {
  std::vector<Index> number(mesh.vertexCount(), kNoIndex), triangles;
  std::vector<double> positions;
  std::vector<SurfacePoint> onOriginal;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (poll.stopped()) break;
    if (!mesh.isVertexAlive(v)) continue;
    number[v] = static_cast<Index>(onOriginal.size());
    const Vec3& p = mesh.position(v);
    positions.insert(positions.end(), {p.x, p.y, p.z});
    onOriginal.push_back(placeOf(v));
  }
  if (poll.stoppedByNow()) return CancellationPoll::error();
  for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.isAlive(h / 3)) triangles.push_back(number[mesh.from(h)]);
  }
  auto surface = SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
  if (!surface) return surface.error();
  return RemeshedSurface{std::move(surface).value(), std::move(onOriginal)};
}

NearestSearch::Found nearestFacing(const SurfaceMesh& original, const NearestSearch& search,
                                   const std::vector<Vec3>& faceNormals, const ChangingMesh& mesh,
                                   Index vertex, Index hint) {
  Vec3 normal;
  mesh.forEachOutgoing(vertex, [&](Index h) { normal = normal + mesh.areaVector(h / 3); });
  const Vec3& place = mesh.position(vertex);
  const auto isOwn = [&](Index f) { return componentOf(original, f) == mesh.component(vertex); };
  const auto found = search.nearest(
      place, [&](Index f) { return dot(faceNormals[f], normal) > 0 && isOwn(f); }, hint);
  return found.triangle == kNoIndex ? search.nearest(place, isOwn) : found;
}

}  // namespace girth::remeshing
