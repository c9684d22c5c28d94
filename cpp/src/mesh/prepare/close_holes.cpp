#include "mesh/prepare/close_holes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/face_shape.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

constexpr std::size_t kMostEdgesForLeastArea = 100;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class HoleFiller {
 public:
  HoleFiller(const SurfaceMesh& mesh, bool fansOnly) : mesh_(mesh), fansOnly_(fansOnly) {
    double extent = 0;
    for (const Vertex v : mesh.vertices()) {
      const Vec3& p = mesh.position(v);
      extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    scale_ = scaleFor(extent);
  }

  HoleFillings run(const std::function<bool(Halfedge)>& isWanted) {
    std::vector<bool> walked(mesh_.halfedgeCount(), false);
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.twin(h) != kNoIndex || walked[h]) continue;
      std::vector<Index> curve;
      bool isFilled = true;
      for (Halfedge boundary = h; !walked[boundary];
           boundary = mesh_.outgoing(mesh_.to(boundary))) {
        walked[boundary] = true;
        curve.push_back(mesh_.from(boundary));
        isFilled = isFilled && (!isWanted || isWanted(boundary));
      }
      if (!isFilled) continue;
      // The other side of the boundary: the filling's faces run against them.
      std::reverse(curve.begin(), curve.end());
      fill(curve);
    }
    return std::move(fillings_);
  }

 private:
  Vec3 scaled(Index vertex) const { return scale_ * mesh_.position(Vertex(vertex)); }

  void fill(const std::vector<Index>& curve) {
    std::vector<Index> triangles;
    double area = kInfinity;
    if (curve.size() <= kMostEdgesForLeastArea && !fansOnly_) area = leastArea(curve, triangles);
    Vec3 middle;
    if (area == kInfinity) {
      area = fan(curve, middle);
      if (area == kInfinity) return;
      const auto centre = static_cast<Index>(mesh_.vertexCount() + fillings_.positions.size() / 3);
      fillings_.positions.insert(fillings_.positions.end(), {middle.x, middle.y, middle.z});
      for (std::size_t i = 0; i < curve.size(); ++i) {
        triangles.insert(triangles.end(), {curve[i], curve[(i + 1) % curve.size()], centre});
      }
    }
    ClosedHole hole;
    hole.edges = static_cast<Index>(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      hole.perimeter += norm(scaled(curve[(i + 1) % curve.size()]) - scaled(curve[i]));
    }
    hole.perimeter /= scale_;
    hole.area = area / scale_ / scale_;
    hole.vertex = *std::min_element(curve.begin(), curve.end());
    fillings_.holes.push_back(hole);
    fillings_.triangles.insert(fillings_.triangles.end(), triangles.begin(), triangles.end());
  }

  /// The area of a face; infinite where it has none to speak of.
  static double areaOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    const FaceShape shape({a, b, c});
    return shape.hasArea() ? shape.doubleArea / 2 : kInfinity;
  }

  /// Whether a mesh edge joins two vertices.
  bool areJoined(Index a, Index b) const {
    for (Halfedge h = mesh_.outgoing(Vertex(a));;) {
      if (mesh_.to(h) == b) return true;
      const Halfedge back = SurfaceMesh::previous(h);
      if (mesh_.from(back) == b) return true;
      h = mesh_.twin(back);
      if (h == kNoIndex || h == mesh_.outgoing(Vertex(a))) return false;
    }
  }

  /// The triangulation of a polygon of least area, by its parts from corner i to corner j.
  double leastArea(const std::vector<Index>& curve, std::vector<Index>& triangles) const {
    const std::size_t n = curve.size();
    std::vector<Vec3> p(n);
    for (std::size_t i = 0; i < n; ++i) p[i] = scaled(curve[i]);
    std::vector<double> least(n * n, 0);
    std::vector<std::size_t> apex(n * n, 0);
    for (std::size_t width = 2; width < n; ++width) {
      for (std::size_t i = 0; i + width < n; ++i) {
        const std::size_t j = i + width;
        double best = kInfinity;
        // A diagonal must not be an edge already; the last one is a side of the polygon.
        if (width + 1 == n || !areJoined(curve[i], curve[j])) {
          for (std::size_t k = i + 1; k < j; ++k) {
            const double parts = least[i * n + k] + least[k * n + j];
            if (!(parts < best)) continue;
            const double area = parts + areaOf(p[i], p[k], p[j]);
            if (!(area < best)) continue;
            best = area;
            apex[i * n + j] = k;
          }
        }
        least[i * n + j] = best;
      }
    }
    if (least[n - 1] == kInfinity) return kInfinity;
    std::vector<std::pair<std::size_t, std::size_t>> todo{{0, n - 1}};
    while (!todo.empty()) {
      const auto [i, j] = todo.back();
      todo.pop_back();
      if (j - i < 2) continue;
      const std::size_t k = apex[i * n + j];
      triangles.insert(triangles.end(), {curve[i], curve[k], curve[j]});
      todo.emplace_back(k, j);
      todo.emplace_back(i, k);
    }
    return least[n - 1];
  }

  /// The area of a fan round the middle of a curve, which it finds.
  double fan(const std::vector<Index>& curve, Vec3& middle) const {
    Vec3 sum;
    double weights = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec3 a = scaled(curve[i]), b = scaled(curve[(i + 1) % curve.size()]);
      const double weight = norm(b - a);
      sum = sum + 0.5 * weight * (a + b);
      weights += weight;
    }
    const Vec3 centre = 1 / weights * sum;
    double area = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      area += areaOf(scaled(curve[i]), scaled(curve[(i + 1) % curve.size()]), centre);
    }
    middle = {centre.x / scale_, centre.y / scale_, centre.z / scale_};
    return area;
  }

  const SurfaceMesh& mesh_;
  bool fansOnly_;
  double scale_;
  HoleFillings fillings_;
};

}  // namespace

HoleFillings fillHoles(const SurfaceMesh& mesh, bool fansOnly,
                       const std::function<bool(Halfedge)>& isWanted) {
  return HoleFiller(mesh, fansOnly).run(isWanted);
}

}  // namespace girth::prepare
