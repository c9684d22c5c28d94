#include "girth/remove_handles.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "girth/cut_surface.h"
#include "mesh/vector.h"
#include "part_of_work.h"

namespace girth {
namespace {

/// Shares of the way to their neighbours by which rims are drawn back: the first that leaves all
/// triangles their area.
constexpr double kDrawnBack[] = {0.25, 0.0625, 0.015625, 0};

Index genusOf(const SurfaceMesh& mesh) {
  Index genus = 0;
  for (Index c = 0; c < mesh.componentCount(); ++c) genus += mesh.genus(c);
  return genus;
}

/// The faces that a curve runs through or along.
std::set<Index> facesAlong(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points) {
  std::set<Index> faces;
  const auto addAround = [&](Vertex vertex) {
    const Halfedge first = mesh.outgoing(vertex);
    for (Halfedge h = first;;) {
      faces.insert(SurfaceMesh::faceOf(h));
      const Halfedge next = mesh.twin(SurfaceMesh::previous(h));
      if (next == first || next == Halfedge::none) break;
      h = next;
    }
  };
  for (const SurfacePoint& point : points) {
    if (point.kind == SurfacePoint::Kind::InFace) {
      faces.insert(point.element);
    } else if (point.kind == SurfacePoint::Kind::AtVertex) {
      addAround(point.vertex());
    } else {
      addAround(mesh.from(point.halfedge()));
      addAround(mesh.to(point.halfedge()));
    }
  }
  return faces;
}

/// The cut surface with its rims drawn back. Error: that of SurfaceMesh::fromArrays.
Result<SurfaceMesh> drawnBack(const CutSurface& cut, double share) {
  const SurfaceMesh& mesh = cut.mesh;
  std::vector<bool> isRim(mesh.vertexCount(), false);
  for (const Face f : mesh.faces()) {
    if (cut.faces[f] != Face::none) continue;
    for (const Vertex v : mesh.faceVertices(f)) isRim[v] = v < cut.points.size();
  }
  // The mean way from a vertex of a rim to its neighbours off the rim, and from the middle of a cap
  // that of the vertices round it.
  std::vector<Vec3> moves(mesh.vertexCount());
  for (const bool isMiddle : {false, true}) {
    std::vector<double> counts(mesh.vertexCount(), 0);
    std::vector<Vec3> sums(mesh.vertexCount());
    for (const Halfedge h : mesh.halfedges()) {
      for (const auto& [v, to] :
           {std::pair{mesh.from(h), mesh.to(h)}, {mesh.to(h), mesh.from(h)}}) {
        if (isMiddle ? v < cut.points.size() || !isRim[to]
                     : !isRim[v] || isRim[to] || to >= cut.points.size()) {
          continue;
        }
        sums[v] = sums[v] + (isMiddle ? moves[to] : mesh.position(to) - mesh.position(v));
        counts[v] += 1;
      }
    }
    for (const Vertex v : mesh.vertices()) {
      if (counts[v] > 0) moves[v] = (1 / counts[v]) * sums[v];
    }
  }
  std::vector<double> positions;
  std::vector<Index> triangles;
  for (const Vertex v : mesh.vertices()) {
    const Vec3 place = mesh.position(v) + share * moves[v];
    positions.insert(positions.end(), {place.x, place.y, place.z});
  }
  for (const Halfedge h : mesh.halfedges()) triangles.push_back(mesh.from(h));
  return SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
}

bool touchesBoundary(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points) {
  return std::any_of(points.begin(), points.end(), [&](const SurfacePoint& point) {
    return point.kind == SurfacePoint::Kind::AtVertex && mesh.isBoundary(point.vertex());
  });
}

/// The short loops that lie apart from each other and off the boundary, the shortest first.
std::vector<Handle> apart(const SurfaceMesh& mesh, const std::vector<Handle>& handles,
                          double length) {
  std::vector<Handle> chosen;
  std::set<Index> taken;
  for (const Handle& handle : handles) {
    if (!(handle.length < length) || touchesBoundary(mesh, handle.points)) continue;
    const std::set<Index> faces = facesAlong(mesh, handle.points);
    if (std::any_of(faces.begin(), faces.end(), [&](Index f) { return taken.count(f) > 0; })) {
      continue;
    }
    taken.insert(faces.begin(), faces.end());
    chosen.push_back(handle);
  }
  return chosen;
}

}  // namespace

Result<HandleRemoval> removeHandles(const SurfaceMesh& mesh, double length,
                                    const HandleOptions& options, const ExecutionContext& context) {
  if (!(length >= 0)) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "handles are removed up to a length of at least 0");
  }
  HandleRemoval result{mesh, {}, genusOf(mesh), genusOf(mesh)};
  while (true) {
    const double done = result.genusBefore == 0 ? 0
                                                : 1 - static_cast<double>(result.genusAfter) /
                                                          static_cast<double>(result.genusBefore);
    const auto found = findHandles(result.mesh, options, partOf(context, done, done));
    if (!found) return found.error();
    std::vector<Handle> chosen = apart(result.mesh, found.value().handles, length);
    if (chosen.empty()) break;
    std::vector<SurfaceCurve> curves;
    for (const Handle& handle : chosen) curves.push_back(handle.points);
    const auto cut = cutSurface(result.mesh, curves, {true}, {1, context.cancel, {}});
    if (!cut) return cut.error();
    Result<SurfaceMesh> closed = makeError(ErrorCode::Internal, -1, "no rim was drawn back");
    for (const double share : kDrawnBack) {
      closed = drawnBack(cut.value(), share);
      if (closed) break;
    }
    if (!closed) return closed.error();
    const Index genus = genusOf(closed.value());
    if (genus >= result.genusAfter) break;  // nothing is gained
    result.mesh = std::move(closed).value();
    result.genusAfter = genus;
    result.removed.insert(result.removed.end(), std::make_move_iterator(chosen.begin()),
                          std::make_move_iterator(chosen.end()));
  }
  if (context.onProgress) context.onProgress(1);
  return result;
}

}  // namespace girth
