#include "mesh/prepare/close_holes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "infinity.h"
#include "mesh/face_shape.h"
#include "mesh/prepare/face_overlap.h"
#include "mesh/prepare/least_area.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

constexpr std::size_t kMostEdgesForLeastArea = 100;
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
    if (area < kInfinity && liesOnFaces(curve, triangles, {})) {
      triangles.clear();
      area = kInfinity;
    }
    Vec3 middle;
    if (area == kInfinity) {
      area = fan(curve, middle);
      if (area == kInfinity || liesOnFaces(curve, {}, middle)) return;
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

  /// The least area of a triangulation of a curve; infinite where there is none.
  double leastArea(const std::vector<Index>& curve, std::vector<Index>& triangles) const {
    std::vector<Vec3> polygon;
    polygon.reserve(curve.size());
    for (const Index vertex : curve) polygon.push_back(scaled(vertex));
    // A diagonal must not be an edge already.
    const auto found = leastAreaTriangulation(
        polygon, [&](std::size_t i, std::size_t j) { return !areJoined(curve[i], curve[j]); });
    if (!found) return kInfinity;
    for (const auto& corners : found->triangles) {
      for (const std::size_t corner : corners) triangles.push_back(curve[corner]);
    }
    return found->area;
  }

  /// Whether a face of a filling would lie on one of the surface: of `triangles`, or, where there
  /// are none, of the fan round `middle`.
  bool liesOnFaces(const std::vector<Index>& curve, const std::vector<Index>& triangles,
                   const Vec3& middle) {
    if (!overlap_) overlap_.emplace(mesh_, scale_);
    const Index component = mesh_.componentOf(Vertex(curve[0]));
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      if (overlap_->covers(
              {scaled(triangles[i]), scaled(triangles[i + 1]), scaled(triangles[i + 2])},
              component)) {
        return true;
      }
    }
    for (std::size_t i = 0; triangles.empty() && i < curve.size(); ++i) {
      const Vec3 next = scaled(curve[(i + 1) % curve.size()]);
      if (overlap_->covers({scaled(curve[i]), next, scale_ * middle}, component)) return true;
    }
    return false;
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
  std::optional<FaceOverlap> overlap_;
  HoleFillings fillings_;
};

}  // namespace

HoleFillings fillHoles(const SurfaceMesh& mesh, bool fansOnly,
                       const std::function<bool(Halfedge)>& isWanted) {
  return HoleFiller(mesh, fansOnly).run(isWanted);
}

}  // namespace girth::prepare
