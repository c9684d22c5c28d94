#include "girth/study/surface_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "geodesic/fast_marching.h"
#include "girth/geodesic_solver.h"
#include "girth/remesh.h"
#include "girth/vertex_function.h"
#include "mesh/mesh_arrays.h"
#include "mesh/vector.h"
#include "mesh/vertex_normals.h"
#include "random.h"

namespace girth::study {

namespace {

constexpr double kMostStretch = 100;
constexpr std::size_t kPlaces = 300;
/// An eighth of the vertices at least comes evenly spread, before their neighbours.
constexpr std::size_t kSpread = 8;
/// The way along the surface is at least so many times the gap.
constexpr double kLeastDetour = 2;
/// Ends of different pairs are so far apart, as a share of the root of the area.
constexpr double kApart = 0.15;

Error optionError(std::string message) {
  return makeError(ErrorCode::InvalidOption, -1, std::move(message));
}

/// With the chosen coordinate multiplied.
Result<SurfaceMesh> stretched(const SurfaceMesh& mesh, double Vec3::*axis, double factor) {
  std::vector<Vec3> positions = positionsOf(mesh);
  for (Vec3& p : positions) p.*axis *= factor;
  return surfaceOf(positions, trianglesOf(mesh));
}

double extentAlong(const SurfaceMesh& mesh, double Vec3::*axis) {
  double low = mesh.position(Vertex(0)).*axis, high = low;
  for (const Vertex v : mesh.vertices()) {
    low = std::min(low, mesh.position(v).*axis);
    high = std::max(high, mesh.position(v).*axis);
  }
  return high - low;
}

/// The vector of length 1 in its direction, or 0 where it has none.
Vec3 unitVector(const Vec3& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vec3{};
}

}  // namespace

Result<SurfaceMesh> remeshedUnevenly(const SurfaceMesh& mesh, Index faces, double stretch,
                                     const ExecutionContext& context) {
  if (!(stretch >= 1 && stretch <= kMostStretch)) {
    return optionError("triangles can be drawn out 1 to 100 times");
  }
  double Vec3::*longest = &Vec3::x;
  for (double Vec3::*axis : {&Vec3::y, &Vec3::z}) {
    if (extentAlong(mesh, axis) > extentAlong(mesh, longest)) longest = axis;
  }
  const auto drawn = stretched(mesh, longest, stretch);
  if (!drawn) return drawn.error();
  const auto remeshed = remesh(drawn.value(), {faces, RemeshMethod::Even}, context);
  if (!remeshed) return remeshed.error();
  return stretched(remeshed.value().mesh, longest, 1 / stretch);
}

Result<SurfaceMesh> withNoise(const SurfaceMesh& mesh, double amount, std::uint64_t seed) {
  if (!(amount >= 0 && amount <= kMostNoise)) {
    return optionError("noise is 0 to 4 mean edge lengths");
  }
  Random random(seed);
  std::vector<Vec3> positions = positionsOf(mesh);
  for (Vec3& p : positions) {
    Vec3 direction;
    double length = 0;
    do {
      direction = {2 * random() - 1, 2 * random() - 1, 2 * random() - 1};
      length = norm(direction);
    } while (!(length > 0.01 && length <= 1));
    p = p + (random() * amount * mesh.meanEdgeLength() / length) * direction;
  }
  return surfaceOf(positions, trianglesOf(mesh));
}

Result<Subdivision> subdivided(const SurfaceMesh& mesh) {
  std::vector<Vec3> positions = positionsOf(mesh);
  std::vector<std::array<Vertex, 2>> between;
  std::vector<Index> middle(mesh.halfedgeCount(), kNoIndex);
  for (const Halfedge h : mesh.halfedges()) {
    if (middle[h] != kNoIndex) continue;
    middle[h] = static_cast<Index>(positions.size());
    if (mesh.twin(h) != kNoIndex) middle[mesh.twin(h)] = middle[h];
    between.push_back({mesh.from(h), mesh.to(h)});
    positions.push_back(0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
  }
  std::vector<Index> triangles;
  triangles.reserve(4 * static_cast<std::size_t>(mesh.halfedgeCount()));
  for (const Face f : mesh.faces()) {
    const Index ab = middle[3 * f], bc = middle[3 * f + 1], ca = middle[3 * f + 2];
    const auto [a, b, c] = mesh.faceVertices(f);
    triangles.insert(triangles.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  auto finer = surfaceOf(positions, triangles);
  if (!finer) return finer.error();
  return Subdivision{std::move(finer).value(), std::move(between)};
}

Result<SurfaceMesh> withHumps(const SurfaceMesh& mesh, const HumpOptions& options,
                              const ExecutionContext& context) {
  const double radius = options.radius * std::sqrt(mesh.area());
  if (!(options.humps > 0 && options.radius > 0 && options.height > 0 && std::isfinite(radius) &&
        std::isfinite(options.height))) {
    return optionError("humps have a number, a radius and a height above 0");
  }
  std::vector<SurfacePoint> middles;
  for (const Vertex v : coarseToFineOrder(mesh, kSpread)) {
    if (middles.size() < options.humps) middles.push_back(SurfacePoint::atVertex(v));
  }
  const auto distances = GeodesicSolver(mesh).distances(middles, radius, context);
  if (!distances) return distances.error();
  const std::vector<Vec3> normals = normalsOfVertices(mesh);
  std::vector<Vec3> positions = positionsOf(mesh);
  for (const Vertex v : mesh.vertices()) {
    const double d = distances.value()[v] / radius;
    if (!(d < 1)) continue;
    const double rise = options.height * radius * (1 - d * d) * (1 - d * d);
    positions[v] = positions[v] + rise * unitVector(normals[v]);
  }
  return surfaceOf(positions, trianglesOf(mesh));
}

Result<SurfaceMesh> withBridge(const SurfaceMesh& mesh, Face face1, Face face2) {
  if (face1 >= mesh.faceCount() || face2 >= mesh.faceCount()) {
    return optionError("faces are numbered from 0 to " + std::to_string(mesh.faceCount() - 1));
  }
  const std::array<Vertex, 3> a = mesh.faceVertices(face1), b = mesh.faceVertices(face2);
  for (const Vertex v : a) {
    if (std::find(b.begin(), b.end(), v) != b.end()) {
      return optionError("faces " + std::to_string(face1) + " and " + std::to_string(face2) +
                         " have vertex " + std::to_string(v) + " in common");
    }
  }
  // Round the first face forward, round the second backward, from where the tube is shortest.
  std::size_t turn = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < 3; ++t) {
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      length += norm(mesh.position(a[i]) - mesh.position(b[(t + 3 - i) % 3]));
    }
    if (length < shortest) {
      shortest = length;
      turn = t;
    }
  }
  std::vector<Index> triangles;
  for (const Face f : mesh.faces()) {
    if (f == face1 || f == face2) continue;
    for (const Vertex v : mesh.faceVertices(f)) triangles.push_back(v);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Index a0 = a[i], a1 = a[(i + 1) % 3];
    const Index b0 = b[(turn + 3 - i) % 3], b1 = b[(turn + 2 - i) % 3];
    triangles.insert(triangles.end(), {a0, a1, b1, a0, b1, b0});
  }
  return surfaceOf(positionsOf(mesh), triangles);
}

Result<SurfaceMesh> withBridges(const SurfaceMesh& mesh, std::vector<std::pair<Face, Face>> pairs) {
  SurfaceMesh result = mesh;
  while (!pairs.empty()) {
    const auto [one, other] = pairs.back();
    pairs.pop_back();
    auto next = withBridge(result, one, other);
    if (!next) return next;
    result = std::move(next).value();
    // A bridge takes two faces out, so that the numbers of those behind fall.
    for (auto& [a, b] : pairs) {
      for (Face* face : {&a, &b}) {
        *face = Face(*face - (*face > one ? 1u : 0u) - (*face > other ? 1u : 0u));
      }
    }
  }
  return result;
}

Result<SurfaceMesh> withTinyHandles(const SurfaceMesh& mesh, std::size_t count) {
  std::vector<std::vector<Index>> neighbours(mesh.vertexCount());
  for (const Halfedge h : mesh.halfedges()) {
    neighbours[mesh.from(h)].push_back(mesh.to(h));
    neighbours[mesh.to(h)].push_back(mesh.from(h));
  }
  std::vector<bool> taken(mesh.vertexCount(), false);
  const auto isFree = [&](Face face) {
    const auto corners = mesh.faceVertices(face);
    return std::none_of(corners.begin(), corners.end(), [&](Vertex v) { return taken[v]; });
  };
  const auto takeRound = [&](Face face) {
    for (const Vertex v : mesh.faceVertices(face)) {
      taken[v] = true;
      for (const Index w : neighbours[v]) taken[w] = true;
    }
  };
  // The nearest face, from neighbour to neighbour, that no edge joins with the first one.
  const auto across = [&](Face first) -> std::optional<Face> {
    constexpr std::size_t kMostFaces = 200;
    std::vector<Face> around{first};
    for (std::size_t i = 0; i < around.size() && around.size() < kMostFaces; ++i) {
      if (isFree(around[i])) return around[i];
      for (Index k = 0; k < 3; ++k) {
        const Halfedge twin = mesh.twin(Halfedge(3 * around[i] + k));
        if (twin == kNoIndex) continue;
        const Face next = SurfaceMesh::faceOf(twin);
        if (std::find(around.begin(), around.end(), next) == around.end()) around.push_back(next);
      }
    }
    return std::nullopt;
  };
  std::vector<std::pair<Face, Face>> pairs;
  for (const Vertex v : coarseToFineOrder(mesh, kSpread)) {
    if (pairs.size() == count) break;
    const Face first = SurfaceMesh::faceOf(mesh.outgoing(v));
    if (!isFree(first)) continue;
    const std::vector<bool> before = taken;
    takeRound(first);
    if (const auto second = across(first)) {
      takeRound(*second);
      pairs.emplace_back(first, *second);
    } else {
      taken = before;
    }
  }
  if (pairs.size() < count) {
    return optionError("there is no room for " + std::to_string(count) + " tiny handles");
  }
  return withBridges(mesh, std::move(pairs));
}

Result<std::vector<std::pair<Face, Face>>> facingPlaces(const SurfaceMesh& mesh, std::size_t count,
                                                        const ExecutionContext& context) {
  std::vector<Vertex> places = coarseToFineOrder(mesh, kSpread);
  places.resize(std::min(places.size(), kPlaces));
  const std::size_t n = places.size();
  const std::vector<Vec3> normals = normalsOfVertices(mesh);
  const geodesic::MarchingStencils stencils(mesh);
  geodesic::FastMarching march(stencils);
  std::vector<double> along(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    march.run(places[i], [](Index, double) { return true; });
    for (std::size_t j = 0; j < n; ++j) along[i * n + j] = march.distance(places[j]);
  }
  struct Pair {
    double detour;
    std::size_t i, j;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vec3 gap = mesh.position(places[j]) - mesh.position(places[i]);
      const bool facing = dot(normals[places[i]], gap) > 0 && dot(normals[places[j]], gap) < 0;
      const double detour = along[i * n + j] / norm(gap);
      if (facing && std::isfinite(detour) && detour >= kLeastDetour)
        pairs.push_back({detour, i, j});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& one, const Pair& other) { return one.detour > other.detour; });
  const double apart = kApart * std::sqrt(mesh.area());
  std::vector<std::size_t> ends;
  std::vector<std::pair<Face, Face>> result;
  for (const Pair& pair : pairs) {
    const bool near = std::any_of(ends.begin(), ends.end(), [&](std::size_t end) {
      return along[end * n + pair.i] < apart || along[end * n + pair.j] < apart;
    });
    if (near || result.size() == count) continue;
    ends.insert(ends.end(), {pair.i, pair.j});
    result.emplace_back(SurfaceMesh::faceOf(mesh.outgoing(places[pair.i])),
                        SurfaceMesh::faceOf(mesh.outgoing(places[pair.j])));
  }
  return result;
}

}  // namespace girth::study
