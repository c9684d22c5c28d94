#include "girth/remove_handles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "girth/cut_surface.h"
#include "loops/cut/closed_rims.h"
#include "loops/handles/handle_tubes.h"
#include "loops/handles/handles_up_to.h"
#include "part_of_work.h"

namespace girth {
namespace {

Index genusOf(const SurfaceMesh& mesh) {
  Index genus = 0;
  for (Index c = 0; c < mesh.componentCount(); ++c) genus += mesh.genus(c);
  return genus;
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
    const std::set<Index> faces = loops::facesAlong(mesh, handle.points);
    if (std::any_of(faces.begin(), faces.end(), [&](Index f) { return taken.count(f) > 0; })) {
      continue;
    }
    taken.insert(faces.begin(), faces.end());
    chosen.push_back(handle);
  }
  return chosen;
}

/// A cut surface without those of its pieces that are tubes, which are spheres once they are
/// closed; nothing where one is none.
std::optional<CutSurface> withoutTubes(const SurfaceMesh& uncut, CutSurface cut,
                                       std::span<const std::optional<loops::HandleTube>> tubes,
                                       std::vector<double>& areas) {
  const SurfaceMesh& whole = cut.mesh;
  std::vector<Index> insides(uncut.vertexCount(), kNoIndex);
  for (std::size_t i = 0; i < tubes.size(); ++i) {
    if (tubes[i]) insides[tubes[i]->inside] = static_cast<Index>(i);
  }
  std::vector<Index> tubeOf(whole.componentCount(), kNoIndex);
  for (Index v = 0; v < cut.points.size(); ++v) {
    const Vertex at = cut.points[v].vertex();
    if (at == Vertex::none || insides[at] == kNoIndex) continue;
    Index& tube = tubeOf[whole.componentOf(Vertex(v))];
    if (tube != kNoIndex || whole.genus(whole.componentOf(Vertex(v))) > 0) return std::nullopt;
    tube = insides[at];
  }
  const auto dropped =
      tubes.size() - static_cast<std::size_t>(std::count(tubes.begin(), tubes.end(), std::nullopt));
  if (whole.componentCount() != uncut.componentCount() + dropped) return std::nullopt;
  areas.assign(tubes.size(), 0);
  if (dropped == 0) return cut;
  std::vector<Index> numbers(whole.vertexCount(), kNoIndex);
  std::vector<double> positions;
  std::vector<SurfacePoint> points;
  std::vector<Face> faces;
  Index count = 0;
  for (const Vertex v : whole.vertices()) {
    if (tubeOf[whole.componentOf(v)] != kNoIndex) continue;
    numbers[v] = count++;
    const Vec3& p = whole.position(v);
    positions.insert(positions.end(), {p.x, p.y, p.z});
    if (v < cut.points.size()) points.push_back(cut.points[v]);
  }
  std::vector<Index> triangles;
  for (const Face f : whole.faces()) {
    const auto corners = whole.faceVertices(f);
    const Index tube = tubeOf[whole.componentOf(corners[0])];
    if (tube != kNoIndex) {
      if (cut.faces[f] != Face::none) areas[tube] += whole.area(f);
      continue;
    }
    for (const Vertex v : corners) triangles.push_back(numbers[v]);
    faces.push_back(cut.faces[f]);
  }
  auto mesh = SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
  if (!mesh) return std::nullopt;
  return CutSurface{std::move(mesh).value(), std::move(points), std::move(faces)};
}

/// A surface without some of its handles.
struct Step {
  loops::ClosedRims closed;
  std::vector<double> droppedAreas;  // 0 where the surface was cut along the loop
};

/// A surface without handles and tunnels: small ones lose the tubes that are given for them, along
/// the loops of the others it is cut. Nothing where a tube is none. Errors: those of cutSurface.
Result<std::optional<Step>> without(const SurfaceMesh& mesh, const std::vector<Handle>& handles,
                                    std::span<const std::optional<loops::HandleTube>> tubes,
                                    const ExecutionContext& context) {
  std::vector<SurfaceCurve> curves;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (tubes[i]) {
      curves.insert(curves.end(), tubes[i]->ends.begin(), tubes[i]->ends.end());
    } else {
      curves.push_back(handles[i].points);
    }
  }
  auto cut = cutSurface(mesh, curves, {true, false}, {1, context.cancel, {}});
  if (!cut) return cut.error();
  std::vector<double> areas;
  auto rest = withoutTubes(mesh, std::move(cut).value(), tubes, areas);
  if (!rest) return std::optional<Step>();
  auto closed = loops::closedRims(*rest, context);
  if (!closed) return closed.error();
  return std::optional<Step>({std::move(closed).value(), std::move(areas)});
}

/// Whether a surface was made that crosses itself nowhere anew.
bool isClear(const Result<std::optional<Step>>& made) {
  return made && made.value() && made.value()->closed.crossingFaces == 0;
}

/// Removes all handles, small ones with their tubes. A tube stays where the surface would cross
/// itself without it. Errors: as above.
Result<Step> without(const SurfaceMesh& mesh, const std::vector<Handle>& handles,
                     const ExecutionContext& context) {
  auto tubes = loops::findHandleTubes(mesh, handles, context);
  if (!tubes) return tubes.error();
  auto dropped = without(mesh, handles, tubes.value(), context);
  if (isClear(dropped)) return std::move(*dropped.value());
  for (std::size_t i = 0; i < handles.size(); ++i) {
    std::optional<loops::HandleTube>& tube = tubes.value()[i];
    if (tube && !isClear(without(mesh, {handles[i]}, std::span(&tube, 1), context))) tube.reset();
  }
  dropped = without(mesh, handles, tubes.value(), context);
  if (isClear(dropped)) return std::move(*dropped.value());
  for (std::optional<loops::HandleTube>& tube : tubes.value()) tube.reset();
  auto cut = without(mesh, handles, tubes.value(), context);
  if (!cut) return cut.error();
  return std::move(*cut.value());
}

}  // namespace

std::vector<RemovedHandle> HandleRemoval::account() const {
  std::vector<RemovedHandle> handles;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const Handle& handle = removed[i];
    handles.push_back({handle.kind, handle.length, handle.centre, droppedAreas[i]});
  }
  return handles;
}

Result<HandleRemoval> removeHandles(const SurfaceMesh& mesh, double length,
                                    const HandleOptions& options, const ExecutionContext& context) {
  if (!(length >= 0)) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "handles are removed up to a length of at least 0");
  }
  HandleRemoval result{mesh, {}, {}, genusOf(mesh), genusOf(mesh), 0, length};
  while (true) {
    const double done = result.genusBefore == 0 ? 0
                                                : 1 - static_cast<double>(result.genusAfter) /
                                                          static_cast<double>(result.genusBefore);
    const ExecutionContext part = partOf(context, done, done);
    const auto found = loops::findHandlesUpTo(
        result.mesh, std::isinf(length) ? std::nullopt : std::optional(length), options, part);
    if (!found) return found.error();
    const std::vector<Handle> chosen = apart(result.mesh, found.value().handles.handles, length);
    if (chosen.empty()) {
      result.provenLength = found.value().proven;
      break;
    }
    auto step = without(result.mesh, chosen, context);
    if (!step) return step.error();
    loops::ClosedRims& closed = step.value().closed;
    const Index genus = genusOf(closed.mesh);
    if (genus >= result.genusAfter) {  // nothing is gained
      result.provenLength = 0;
      break;
    }
    result.mesh = std::move(closed.mesh);
    result.crossingFaces += closed.crossingFaces;
    result.genusAfter = genus;
    result.removed.insert(result.removed.end(), chosen.begin(), chosen.end());
    result.droppedAreas.insert(result.droppedAreas.end(), step.value().droppedAreas.begin(),
                               step.value().droppedAreas.end());
  }
  if (context.onProgress) context.onProgress(1);
  return result;
}

}  // namespace girth
