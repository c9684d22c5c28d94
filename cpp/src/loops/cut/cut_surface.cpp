#include "girth/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "loops/cut/cavities.h"
#include "loops/cut/divided_surface.h"
#include "mesh/neighbours.h"
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

/// A closed curve of the boundary that cutting made.
struct Rim {
  std::vector<Halfedge> sides;
  /// The vertices as the faces beyond run against them.
  std::vector<Index> vertices;
  Vec3 area;  ///< half of it is enclosed, along its normal
};

std::vector<Rim> rimsOf(const SurfaceMesh& mesh, const DividedSurface& divided) {
  std::vector<Rim> rims;
  std::vector<bool> walked(mesh.halfedgeCount(), false);
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.twin(h) != Halfedge::none || walked[h]) continue;
    Rim rim;
    bool isCut = true;
    for (Halfedge at = h; !walked[at]; at = mesh.outgoing(mesh.to(at))) {
      walked[at] = true;
      isCut = isCut && divided.isCut[at];
      rim.sides.push_back(at);
      rim.vertices.push_back(mesh.from(at));
    }
    if (!isCut) continue;
    std::reverse(rim.vertices.begin(), rim.vertices.end());
    const Vec3& o = mesh.position(Vertex(rim.vertices[0]));
    for (std::size_t i = 1; i + 1 < rim.vertices.size(); ++i) {
      rim.area = rim.area + cross(mesh.position(Vertex(rim.vertices[i])) - o,
                                  mesh.position(Vertex(rim.vertices[i + 1])) - o);
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

/// Triangles of the caps with holes, on both sides, and the halfedges that they lie at.
struct HollowFillings {
  std::vector<Index> triangles;
  std::vector<bool> isFilled;
};

Result<HollowFillings> fillHollow(const SurfaceMesh& uncut, const SurfaceMesh& mesh,
                                  const DividedSurface& divided,
                                  const loops::HollowCurves& hollow) {
  HollowFillings fillings{{}, std::vector<bool>(mesh.halfedgeCount(), false)};
  if (hollow.caps.empty()) return fillings;
  std::vector<Vec3> places;
  for (const Vertex v : mesh.vertices()) places.push_back(mesh.position(v));
  const std::vector<Rim> rims = rimsOf(mesh, divided);
  // The rim that a curve left on one side: the nearest to a point of it.
  const auto rimOf = [&](std::size_t curve, const Vec3& normal, bool isAbove) {
    const Vec3 place = positionOf(uncut, hollow.curves[curve].front());
    const Rim* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Rim& rim : rims) {
      if ((dot(rim.area, normal) > 0) != isAbove) continue;
      for (const Index vertex : rim.vertices) {
        if (!(norm(places[vertex] - place) < least)) continue;
        least = norm(places[vertex] - place);
        nearest = &rim;
      }
    }
    return nearest;
  };
  const auto isJoined = [&](Index a, Index b) {
    bool isFound = false;
    forEachNeighbour(mesh, Vertex(a), [&](Vertex v) { isFound = isFound || v == b; });
    return isFound;
  };
  for (const loops::HollowCap& cap : hollow.caps) {
    for (const bool isAbove : {false, true}) {
      const Rim* const rim = rimOf(cap.rim, cap.normal, isAbove);
      if (rim == nullptr) continue;
      std::vector<const Rim*> all{rim};
      std::vector<std::vector<Index>> holes;
      for (const std::size_t curve : cap.holes) {
        const Rim* const hole = rimOf(curve, cap.normal, !isAbove);
        if (hole == nullptr || std::find(all.begin(), all.end(), hole) != all.end()) continue;
        all.push_back(hole);
        holes.push_back(hole->vertices);
      }
      const std::vector<Index> triangles =
          loops::triangulatedCap(rim->vertices, std::move(holes), cap.normal, places, isJoined);
      if (triangles.empty()) {
        Error error = makeError(ErrorCode::InvalidOption, -1,
                                "no cap with holes closes what is cut of a body and its cavities: "
                                "its rims cross, or have too many edges (1000 are possible)");
        error.hint = "cut without caps, or a surface of fewer triangles";
        return error;
      }
      fillings.triangles.insert(fillings.triangles.end(), triangles.begin(), triangles.end());
      for (const Rim* const one : all) {
        for (const Halfedge h : one->sides) fillings.isFilled[h] = true;
      }
    }
  }
  return fillings;
}

/// The surface with its cut rims filled.
Result<SurfaceMesh> capped(const SurfaceMesh& mesh, const DividedSurface& divided,
                           const HollowFillings& hollow, const std::vector<double>& positions,
                           const std::vector<Index>& triangles) {
  Result<SurfaceMesh> closed = makeError(ErrorCode::Internal, -1, "nothing was filled");
  // Two fillings may need the same diagonal; fans never do.
  for (const bool fansOnly : {false, true}) {
    const prepare::HoleFillings fillings = prepare::fillHoles(
        mesh, fansOnly,
        [&](Halfedge halfedge) { return divided.isCut[halfedge] && !hollow.isFilled[halfedge]; });
    std::vector<double> allPositions = positions;
    std::vector<Index> allTriangles = triangles;
    allPositions.insert(allPositions.end(), fillings.positions.begin(), fillings.positions.end());
    allTriangles.insert(allTriangles.end(), fillings.triangles.begin(), fillings.triangles.end());
    allTriangles.insert(allTriangles.end(), hollow.triangles.begin(), hollow.triangles.end());
    closed = SurfaceMesh::fromArrays(allPositions, allTriangles, OpenEdges::Boundary);
    if (closed) break;
  }
  return closed;
}

}  // namespace

Result<CutSurface> cutSurface(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                              const CutOptions& options, const ExecutionContext& context) {
  loops::HollowCurves hollow;
  auto divided = loops::divided(mesh, curves, context);
  if (!divided) return divided.error();
  if (options.cap && options.cutsCavities) {
    hollow = loops::throughCavities(mesh, curves);
    if (!hollow.caps.empty()) divided = loops::divided(mesh, hollow.curves, context);
    if (!divided) return divided.error();
  }
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
  if (cut && options.cap) {
    const auto fillings = fillHollow(mesh, cut.value(), divided.value(), hollow);
    if (!fillings) return fillings.error();
    cut = capped(cut.value(), divided.value(), fillings.value(), positions, apart.corners);
  }
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

namespace {

/// `partOf`: of each component, its part; parts without any are left out.
std::vector<SurfaceComponent> surfacesOf(const SurfaceMesh& mesh,
                                         const std::vector<Index>& partOf) {
  struct Arrays {
    std::vector<double> positions;
    std::vector<Index> triangles;
    std::vector<Vertex> vertices;
    std::vector<Face> faces;
  };
  std::vector<Arrays> arrays(mesh.componentCount());
  std::vector<Index> number(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) {
    Arrays& component = arrays[partOf[mesh.componentOf(v)]];
    number[v] = static_cast<Index>(component.vertices.size());
    component.vertices.push_back(v);
    const Vec3& p = mesh.position(v);
    component.positions.insert(component.positions.end(), {p.x, p.y, p.z});
  }
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    Arrays& component = arrays[partOf[mesh.componentOf(corners[0])]];
    for (const Vertex v : corners) component.triangles.push_back(number[v]);
    component.faces.push_back(f);
  }
  std::vector<SurfaceComponent> components;
  for (Arrays& component : arrays) {
    if (component.faces.empty()) continue;
    // A part of a surface is one.
    components.push_back(
        {SurfaceMesh::fromArrays(component.positions, component.triangles, OpenEdges::Boundary)
             .value(),
         std::move(component.vertices), std::move(component.faces)});
  }
  return components;
}

}  // namespace

std::vector<SurfaceComponent> componentsOf(const SurfaceMesh& mesh) {
  std::vector<Index> partOf(mesh.componentCount());
  std::iota(partOf.begin(), partOf.end(), Index{0});
  return surfacesOf(mesh, partOf);
}

std::vector<SurfaceComponent> partsOf(const SurfaceMesh& mesh) {
  return surfacesOf(mesh, loops::bodiesOf(mesh));
}

}  // namespace girth
