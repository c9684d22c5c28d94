#include "girth/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "loops/divided_surface.h"
#include "mesh/prepare/close_holes.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth {
namespace {

using loops::DividedSurface;

/// Vertices of triangles that are taken apart along the cuts: `corner[h]` is the new vertex that
/// halfedge h starts from, `vertices` says for each the old one, in rising order.
struct Separated {
  std::vector<Index> corners, vertices;
};

/// Corners of a vertex stay together where a way leads from one to the other over no cut.
Separated separated(const DividedSurface& divided) {
  const std::size_t count = divided.triangles.size();
  std::vector<Index> first(count);
  std::iota(first.begin(), first.end(), Index{0});
  const auto find = [&](Index h) {
    while (first[h] != h) {
      first[h] = first[first[h]];
      h = first[h];
    }
    return h;
  };
  const auto join = [&](Index a, Index b) {
    a = find(a);
    b = find(b);
    first[std::max(a, b)] = std::min(a, b);
  };
  for (Index h = 0; h < count; ++h) {
    if (divided.isCut[h] || divided.twins[h] == kNoIndex) continue;
    join(h, nextSide(divided.twins[h]));
    join(nextSide(h), divided.twins[h]);
  }
  std::vector<Index> roots;
  for (Index h = 0; h < count; ++h) {
    if (find(h) == h) roots.push_back(h);
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](Index a, Index b) { return divided.triangles[a] < divided.triangles[b]; });
  Separated result;
  std::vector<Index> number(count, kNoIndex);
  for (const Index root : roots) {
    number[root] = static_cast<Index>(result.vertices.size());
    result.vertices.push_back(divided.triangles[root]);
  }
  for (Index h = 0; h < count; ++h) result.corners.push_back(number[find(h)]);
  return result;
}

/// The surface with its cut rims filled.
Result<SurfaceMesh> capped(const SurfaceMesh& mesh, const DividedSurface& divided,
                           const std::vector<double>& positions,
                           const std::vector<Index>& triangles) {
  Result<SurfaceMesh> closed = makeError(ErrorCode::Internal, -1, "nothing was filled");
  // Two fillings may need the same diagonal; fans never do.
  for (const bool fansOnly : {false, true}) {
    const prepare::HoleFillings fillings = prepare::fillHoles(
        mesh, fansOnly, [&](Halfedge halfedge) { return divided.isCut[halfedge] != 0; });
    std::vector<double> allPositions = positions;
    std::vector<Index> allTriangles = triangles;
    allPositions.insert(allPositions.end(), fillings.positions.begin(), fillings.positions.end());
    allTriangles.insert(allTriangles.end(), fillings.triangles.begin(), fillings.triangles.end());
    closed = SurfaceMesh::fromArrays(allPositions, allTriangles, OpenEdges::Boundary);
    if (closed) break;
  }
  return closed;
}

}  // namespace

Result<CutSurface> cutSurface(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                              const CutOptions& options, const ExecutionContext& context) {
  const auto divided = loops::divided(mesh, curves, context);
  if (!divided) return divided.error();
  if (context.cancelled()) return loops::cutCancelled();
  const Separated apart = separated(divided.value());
  std::vector<SurfacePoint> points;
  std::vector<double> positions;
  for (const Index vertex : apart.vertices) {
    points.push_back(divided.value().points[vertex]);
    const Vec3 place = positionOf(mesh, points.back());
    positions.insert(positions.end(), {place.x, place.y, place.z});
  }
  if (context.cancelled()) return loops::cutCancelled();
  auto cut = SurfaceMesh::fromArrays(positions, apart.corners, OpenEdges::Boundary);
  if (context.cancelled()) return loops::cutCancelled();
  if (cut && options.cap) cut = capped(cut.value(), divided.value(), positions, apart.corners);
  if (!cut) return cut.error();
  std::vector<Face> faces = divided.value().faces;
  faces.resize(cut.value().faceCount(), Face::none);
  return CutSurface{std::move(cut).value(), std::move(points), std::move(faces)};
}

Result<std::vector<CurveSide>> sidesOf(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const auto found = loops::divided(mesh, std::span(&curve, 1));
  if (!found) return found.error();
  const DividedSurface& divided = found.value();
  const std::vector<Index> parts = loops::partsOf(divided);
  const auto place = [&](Index vertex) { return positionOf(mesh, divided.points[vertex]); };
  // The apex of the cones.
  Vec3 sum;
  double length = 0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const Vec3 a = positionOf(mesh, curve[i]), b = positionOf(mesh, curve[i + 1]);
    sum = sum + (norm(b - a) / 2) * (a + b);
    length += norm(b - a);
  }
  const Vec3 centre = length > 0 ? (1 / length) * sum : Vec3{};
  std::vector<CurveSide> all(parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1);
  std::vector<bool> touchesCurve(all.size(), false);
  for (Index h = 0; h < divided.triangles.size(); ++h) {
    CurveSide& side = all[parts[faceOfSide(h)]];
    if (divided.isCut[h]) touchesCurve[parts[faceOfSide(h)]] = true;
    if (divided.twins[h] == kNoIndex) side.volume = std::numeric_limits<double>::quiet_NaN();
    if (h % 3 != 0) continue;
    const Vec3 a = place(divided.triangles[h]) - centre,
               b = place(divided.triangles[h + 1]) - centre,
               c = place(divided.triangles[h + 2]) - centre;
    side.area += norm(cross(b - a, c - a)) / 2;
    side.volume += dot(a, cross(b, c)) / 6;
  }
  // Along a boundary nothing is cut: then the only side is the component.
  if (!curve.empty() &&
      std::find(touchesCurve.begin(), touchesCurve.end(), true) == touchesCurve.end()) {
    const SurfacePoint& point = curve.front();
    const Vertex vertex = point.kind == SurfacePoint::Kind::AtVertex ? point.vertex()
                          : point.kind == SurfacePoint::Kind::OnEdge
                              ? mesh.from(point.halfedge())
                              : mesh.faceVertices(point.face())[0];
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Vertex corner = mesh.faceVertices(divided.faces[i])[0];
      if (mesh.componentOf(corner) == mesh.componentOf(vertex)) touchesCurve[parts[i]] = true;
    }
  }
  std::vector<CurveSide> sides;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (touchesCurve[i]) sides.push_back(all[i]);
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const CurveSide& a, const CurveSide& b) { return a.area > b.area; });
  return sides;
}

std::vector<SurfaceComponent> componentsOf(const SurfaceMesh& mesh) {
  struct Arrays {
    std::vector<double> positions;
    std::vector<Index> triangles;
    std::vector<Vertex> vertices;
    std::vector<Face> faces;
  };
  std::vector<Arrays> arrays(mesh.componentCount());
  std::vector<Index> number(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) {
    Arrays& component = arrays[mesh.componentOf(v)];
    number[v] = static_cast<Index>(component.vertices.size());
    component.vertices.push_back(v);
    const Vec3& p = mesh.position(v);
    component.positions.insert(component.positions.end(), {p.x, p.y, p.z});
  }
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    Arrays& component = arrays[mesh.componentOf(corners[0])];
    for (const Vertex v : corners) component.triangles.push_back(number[v]);
    component.faces.push_back(f);
  }
  std::vector<SurfaceComponent> components;
  for (Arrays& component : arrays) {
    // A part of a surface is one.
    components.push_back(
        {SurfaceMesh::fromArrays(component.positions, component.triangles, OpenEdges::Boundary)
             .value(),
         std::move(component.vertices), std::move(component.faces)});
  }
  return components;
}

}  // namespace girth
