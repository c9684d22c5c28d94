#include "girth/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "mesh/angles.h"
#include "mesh/coordinates.h"
#include "mesh/edge_groups.h"
#include "mesh/face_shape.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth {

namespace {

std::string faceText(Index face) { return "face " + std::to_string(face); }

std::string edgeText(Index a, Index b) {
  return "edge " + std::to_string(a) + "-" + std::to_string(b);
}

/// Checks what the arrays alone can show.
std::optional<Error> findBadElement(std::span<const double> positions,
                                    std::span<const Index> triangles) {
  const std::size_t vertices = positions.size() / 3, faces = triangles.size() / 3;
  if (faces == 0 || triangles.size() % 3 != 0 || positions.size() % 3 != 0) {
    return makeError(ErrorCode::EmptyMesh, -1,
                     faces == 0 ? "the mesh has no faces" : "the arrays are not whole triples");
  }
  // Halfedge numbers and a flag bit must fit into an Index.
  if (triangles.size() >= 0x7FFFFFFFu || vertices >= 0x7FFFFFFFu) {
    return makeError(ErrorCode::LimitExceeded, -1, "the mesh has over 700 million faces");
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    if (auto error = badCoordinateOf(v, positions)) return error;
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const Index a = triangles[3 * f], b = triangles[3 * f + 1], c = triangles[3 * f + 2];
    const Index largest = std::max({a, b, c});
    if (largest >= vertices) {
      return makeError(ErrorCode::IndexOutOfRange, static_cast<std::int64_t>(f),
                       faceText(static_cast<Index>(f)) + " names vertex " +
                           std::to_string(largest) + " of " + std::to_string(vertices));
    }
    if (a == b || b == c || c == a) {
      return makeError(ErrorCode::DegenerateFace, static_cast<std::int64_t>(f),
                       faceText(static_cast<Index>(f)) + " repeats vertex " +
                           std::to_string(a == b || a == c ? a : b));
    }
  }
  return std::nullopt;
}

/// Pairs the halfedges of every edge. `from` holds the start of each halfedge.
std::optional<Error> pairHalfedges(const std::vector<Index>& from, Index vertices,
                                   OpenEdges openEdges, std::vector<Index>& twin) {
  const auto count = static_cast<Index>(from.size());
  const auto to = [&](Index h) { return from[nextSide(h)]; };
  twin.assign(count, kNoIndex);
  Index worst = kNoIndex;  // the first halfedge, by number, with anything wrong
  ErrorCode code{};
  std::size_t faces = 0;
  EdgeGroups(from, vertices).forEach([&](const EdgeGroup& edge) {
    const Index a = edge[0];
    if (edge.size() == 2 && from[a] != from[edge[1]]) {
      twin[a] = edge[1];
      twin[edge[1]] = a;
    } else if (a < worst && !(edge.size() == 1 && openEdges == OpenEdges::Boundary)) {
      worst = a;
      faces = edge.size();
      code = faces == 1   ? ErrorCode::OpenEdge
             : faces == 2 ? ErrorCode::InconsistentOrientation
                          : ErrorCode::NonManifoldEdge;
    }
  });
  if (worst == kNoIndex) return std::nullopt;
  std::string where = edgeText(from[worst], to(worst)) + " of " + faceText(worst / 3);
  if (code == ErrorCode::OpenEdge)
    return makeError(code, worst, where + " has no face on its other side");
  if (code == ErrorCode::NonManifoldEdge) {
    return makeError(code, worst, where + " has " + std::to_string(faces) + " faces");
  }
  return makeError(code, worst, where + " runs the same way in both of its faces");
}

}  // namespace

Result<SurfaceMesh> SurfaceMesh::fromArrays(std::span<const double> positions,
                                            std::span<const Index> triangles, OpenEdges openEdges) {
  if (auto error = findBadElement(positions, triangles)) return *std::move(error);

  SurfaceMesh mesh;
  mesh.from_.assign(triangles.begin(), triangles.end());
  mesh.positions_.resize(positions.size() / 3);
  for (const Vertex v : mesh.vertices()) {
    mesh.positions_[v] = {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
  }
  const Index vertices = mesh.vertexCount(), halfedges = mesh.halfedgeCount();

  // Lengths, angles and areas. Products of coordinates are formed at a scale near 1, a power of two
  // away, so that models of any size neither overflow nor lose bits.
  double extent = 0;
  for (const double x : positions) extent = std::max(extent, std::fabs(x));
  const double shrink = scaleFor(extent);
  mesh.length_.resize(halfedges);
  mesh.cornerAngle_.resize(halfedges);
  mesh.totalAngle_.assign(vertices, 0.0);
  double scaledArea = 0, scaledLength = 0;
  for (const Face f : mesh.faces()) {
    std::array<Vec3, 3> corner;
    for (Index k = 0; k < 3; ++k) corner[k] = shrink * mesh.positions_[mesh.from_[3 * f + k]];
    const FaceShape shape(corner);
    if (!shape.hasArea()) {
      return makeError(ErrorCode::DegenerateFace, f, faceText(f) + " has no area");
    }
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + k;
      mesh.length_[h] = shape.length[k] / shrink;
      mesh.cornerAngle_[h] =
          angleOf(-dot(shape.side[k], shape.side[(k + 2) % 3]), shape.doubleArea);
      mesh.totalAngle_[mesh.from_[h]] += mesh.cornerAngle_[h];
      scaledLength += shape.length[k];
    }
    scaledArea += shape.doubleArea / 2;
  }
  mesh.area_ = scaledArea / shrink / shrink;
  mesh.meanEdgeLength_ = scaledLength / halfedges / shrink;

  if (auto error = pairHalfedges(mesh.from_, vertices, openEdges, mesh.twin_))
    return *std::move(error);

  // Every vertex must have one fan of faces; at a boundary it begins with the boundary halfedge.
  std::vector<Index> degree(vertices, 0);
  mesh.outgoing_.assign(vertices, kNoIndex);
  Index boundaryEdges = 0;
  for (Index h = halfedges; h-- > 0;) {
    const Index v = mesh.from_[h];
    ++degree[v];
    if (mesh.outgoing_[v] == kNoIndex || mesh.twin_[mesh.outgoing_[v]] != kNoIndex) {
      mesh.outgoing_[v] = h;
    }
    if (mesh.twin_[h] == kNoIndex) {
      mesh.outgoing_[v] = h;
      ++boundaryEdges;
    }
  }
  mesh.edgeCount_ = (halfedges + boundaryEdges) / 2;
  for (Index v = 0; v < vertices; ++v) {
    if (degree[v] == 0) {
      return makeError(ErrorCode::UnreferencedVertex, v,
                       "vertex " + std::to_string(v) + " belongs to no face");
    }
    Index fan = 0;
    Index h = mesh.outgoing_[v];
    do {
      ++fan;
      h = mesh.twin_[previousSide(h)];
    } while (h != kNoIndex && h != mesh.outgoing_[v]);
    if (fan != degree[v]) {
      return makeError(ErrorCode::NonManifoldVertex, v,
                       "vertex " + std::to_string(v) + " joins parts that touch only there");
    }
  }

  // Components by flooding, and the genus of each from V − E + F = 2 − 2g − (boundary curves).
  mesh.component_.assign(vertices, kNoIndex);
  std::vector<Index> front;
  std::vector<bool> walked(boundaryEdges > 0 ? halfedges : 0, false);  // along a boundary curve
  for (Index seed = 0; seed < vertices; ++seed) {
    if (mesh.component_[seed] != kNoIndex) continue;
    const Index number = mesh.componentCount();
    std::int64_t vertexTotal = 0, halfedgeTotal = 0, boundaryTotal = 0;
    Index boundaries = 0;
    mesh.component_[seed] = number;
    front.assign(1, seed);
    const auto meet = [&](Index w) {
      if (mesh.component_[w] != kNoIndex) return;
      mesh.component_[w] = number;
      front.push_back(w);
    };
    while (!front.empty()) {
      const Index v = front.back();
      front.pop_back();
      ++vertexTotal;
      Index h = mesh.outgoing_[v];
      if (mesh.twin_[h] == kNoIndex && !walked[h]) {
        ++boundaries;
        for (Index boundary = h; !walked[boundary];
             boundary = mesh.outgoing_[mesh.to(Halfedge(boundary))]) {
          walked[boundary] = true;
          ++boundaryTotal;
        }
      }
      do {
        ++halfedgeTotal;
        meet(mesh.to(Halfedge(h)));
        meet(mesh.from_[previousSide(h)]);
        h = mesh.twin_[previousSide(h)];
      } while (h != kNoIndex && h != mesh.outgoing_[v]);
    }
    const std::int64_t edges = (halfedgeTotal + boundaryTotal) / 2;
    const std::int64_t euler = vertexTotal - edges + halfedgeTotal / 3;
    mesh.componentGenus_.push_back(static_cast<Index>((2 - euler - boundaries) / 2));
    mesh.componentBoundaries_.push_back(boundaries);
  }
  return mesh;
}

double SurfaceMesh::area(Face face) const {
  const auto [a, b, c] = faceVertices(face);
  return norm(cross(positions_[b] - positions_[a], positions_[c] - positions_[a])) / 2;
}

}  // namespace girth
