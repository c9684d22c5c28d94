#include "mesh/prepare/face_overlap.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "infinity.h"

namespace girth::prepare {

namespace {

constexpr double kCoplanar = 1e-6;
/// Less of the smaller triangle is no overlap, but rounding along a common edge.
constexpr double kOverlap = 1e-6;

Vec3 areaVector(const std::array<Vec3, 3>& corner) {
  return cross(corner[1] - corner[0], corner[2] - corner[0]);
}

/// Twice the area of what a triangle has within the sides of another one, whose normal is given.
double doubleAreaWithin(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 3>& window,
                        const Vec3& normal) {
  std::vector<Vec3> polygon(triangle.begin(), triangle.end()), rest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 inwards = cross(normal, window[(k + 1) % 3] - window[k]);
    rest.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double atP = dot(inwards, p - window[k]), atQ = dot(inwards, q - window[k]);
      if (atP >= 0) rest.push_back(p);
      if ((atP >= 0) != (atQ >= 0)) rest.push_back(p + atP / (atP - atQ) * (q - p));
    }
    polygon.swap(rest);
  }
  Vec3 sum{0, 0, 0};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum = sum + areaVector({polygon[0], polygon[i - 1], polygon[i]});
  }
  return norm(sum);
}

}  // namespace

FaceOverlap::FaceOverlap(const SurfaceMesh& mesh, double scale) : mesh_(mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(mesh.faceCount());
  for (const Face f : mesh.faces()) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = scale * mesh.position(Vertex(mesh.faceVertices(f)[k]));
    }
    triangles.push_back(corners);
  }
  search_ = NearestSearch(std::move(triangles));
}

bool FaceOverlap::covers(const std::array<Vec3, 3>& triangle, Index component) const {
  const Vec3 normal = areaVector(triangle);
  const double doubleArea = norm(normal);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, norm(triangle[(k + 1) % 3] - triangle[k]));
  }
  const double gap = kCoplanar * longest;
  const auto low = [&](double Vec3::*axis) {
    return std::min({triangle[0].*axis, triangle[1].*axis, triangle[2].*axis}) - gap;
  };
  const auto high = [&](double Vec3::*axis) {
    return std::max({triangle[0].*axis, triangle[1].*axis, triangle[2].*axis}) + gap;
  };
  const Vec3 least{low(&Vec3::x), low(&Vec3::y), low(&Vec3::z)};
  const Vec3 most{high(&Vec3::x), high(&Vec3::y), high(&Vec3::z)};
  bool isCovered = false;
  search_.search(
      [&](Index, const NearestSearch::Box& box) {
        const bool meets = box.low.x <= most.x && box.high.x >= least.x && box.low.y <= most.y &&
                           box.high.y >= least.y && box.low.z <= most.z && box.high.z >= least.z;
        return meets && !isCovered ? 0 : kInfinity;
      },
      [&](Index f) {
        const std::array<Vec3, 3>& face = search_.triangle(f);
        const Vec3 other = areaVector(face);
        const double otherArea = norm(other);
        const double along = dot(normal, other);
        if (isCovered || !(norm(cross(normal, other)) <= kCoplanar * doubleArea * otherArea))
          return;
        if (along < 0 && mesh_.componentOf(Vertex(mesh_.faceVertices(Face(f))[0])) != component)
          return;
        for (const Vec3& corner : triangle) {
          if (std::fabs(dot(other, corner - face[0])) > gap * otherArea) return;
        }
        isCovered =
            doubleAreaWithin(face, triangle, normal) > kOverlap * std::min(doubleArea, otherArea);
      });
  return isCovered;
}

}  // namespace girth::prepare
