#include "girth/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/nearest_point.h"
#include "mesh/neighbours.h"
#include "mesh/vertex_normals.h"

namespace girth {

namespace {

/// The vertices that a point lies between, with its shares of them.
struct Shares {
  std::array<Vertex, 3> vertex;
  std::array<double, 3> weight;
  std::size_t count;

  std::size_t largest() const {
    std::size_t k = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (weight[i] > weight[k]) k = i;
    }
    return k;
  }
};

Shares sharesOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      return {{point.vertex()}, {1, 0, 0}, 1};
    case SurfacePoint::Kind::OnEdge:
      return {{mesh.from(point.halfedge()), mesh.to(point.halfedge())}, point.weights, 2};
    case SurfacePoint::Kind::InFace:
      break;
  }
  return {mesh.faceVertices(point.face()), point.weights, 3};
}

}  // namespace

std::vector<SurfacePoint> nearestPoints(const SurfaceMesh& surface, const SurfaceMesh& points) {
  const NearestSearch search = searchOf(surface);
  const std::vector<Vec3> faceNormals = normalsOfFaces(surface);
  const std::vector<Vec3> normals = normalsOfVertices(points);
  std::vector<SurfacePoint> result(points.vertexCount());
  Index hint = kNoIndex;
  for (const Vertex v : points.vertices()) {
    const Vec3& p = points.position(v);
    auto found = search.nearest(
        p, [&](Index f) { return dot(faceNormals[f], normals[v]) >= 0; }, hint);
    if (found.triangle == kNoIndex) found = search.nearest(p);
    hint = found.triangle;
    result[v] = SurfacePoint::inFace(Face(found.triangle), found.weights);
  }
  return result;
}

std::vector<SurfacePoint> nearestPoints(const SurfaceMesh& surface, std::span<const Vec3> places) {
  constexpr double kOnSide = 1e-9;
  const NearestSearch search = searchOf(surface);
  std::vector<SurfacePoint> result;
  result.reserve(places.size());
  Index hint = kNoIndex;
  for (const Vec3& place : places) {
    auto found = search.nearest(
        place, [](Index) { return true; }, hint);
    hint = found.triangle;
    double sum = 0;
    for (double& weight : found.weights) {
      if (weight < kOnSide) weight = 0;
      sum += weight;
    }
    for (double& weight : found.weights) weight /= sum;
    result.push_back(SurfacePoint::inFace(Face(found.triangle), found.weights));
  }
  return result;
}

std::vector<double> interpolated(const SurfaceMesh& surface, std::span<const double> values,
                                 std::span<const SurfacePoint> points, double steepest) {
  std::vector<double> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Shares shares = sharesOf(surface, points[i]);
    bool smooth = true;
    double sum = 0;
    for (std::size_t k = 0; k < shares.count; ++k) {
      const Vertex a = shares.vertex[k], b = shares.vertex[(k + 1) % shares.count];
      const double difference = std::fabs(values[a] - values[b]);
      const double distance = norm(surface.position(a) - surface.position(b));
      if (std::isnan(difference) || difference > steepest * distance) smooth = false;
      sum += shares.weight[k] * values[a];
    }
    result[i] = smooth ? sum : values[shares.vertex[shares.largest()]];
  }
  return result;
}

std::vector<double> carriedBack(const SurfaceMesh& surface, std::span<const double> girth,
                                const SurfaceMesh& other, std::span<const SurfacePoint> nearest) {
  constexpr double kNearly = 1.5, kRounding = 1e-9;
  const std::vector<double> before = interpolated(surface, girth, nearest, kSteepestGirth);
  std::vector<double> values = before;
  using Entry = std::pair<double, Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> lower;
  // Where an edge is no jump: what its end may be at most.
  const auto mostBeyond = [&](Vertex from, Halfedge edge, Vertex end) {
    const double rise = kSteepestGirth * other.length(edge);
    const bool isJump = !(std::fabs(before[from] - before[end]) <= kNearly * rise);
    return isJump ? std::numeric_limits<double>::infinity() : values[from] + rise * (1 - kRounding);
  };
  for (const Vertex v : other.vertices()) {
    forEachEdge(other, v, [&](Halfedge edge, Vertex end) {
      if (values[end] > mostBeyond(v, edge, end)) lower.push({values[v], v});
    });
  }
  while (!lower.empty()) {
    const auto [value, from] = lower.top();
    lower.pop();
    if (value > values[from]) continue;
    forEachEdge(other, from, [&, v = from](Halfedge edge, Vertex end) {
      const double most = mostBeyond(v, edge, end);
      if (!(values[end] > most)) return;
      values[end] = most;
      lower.push({most, end});
    });
  }
  return values;
}

std::vector<Vertex> nearestVertices(const SurfaceMesh& surface,
                                    std::span<const SurfacePoint> points) {
  std::vector<Vertex> result(points.size());
  std::transform(points.begin(), points.end(), result.begin(), [&](const SurfacePoint& point) {
    const Shares shares = sharesOf(surface, point);
    return shares.vertex[shares.largest()];
  });
  return result;
}

}  // namespace girth
