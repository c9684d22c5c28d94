#include "girth/io/attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace girth::io {
namespace {

using Shares = std::array<double, 3>;

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double product(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The barycentric coordinates of the point of a triangle's plane that is next to a point; nothing
/// where the triangle has no area.
std::optional<Shares> sharesIn(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const Vec3 u = minus(corners[1], corners[0]), v = minus(corners[2], corners[0]),
             p = minus(point, corners[0]);
  const double uu = product(u, u), uv = product(u, v), vv = product(v, v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return std::nullopt;
  const double b = (product(p, u) * vv - product(p, v) * uv) / determinant;
  const double c = (product(p, v) * uu - product(p, u) * uv) / determinant;
  return Shares{1 - b - c, b, c};
}

}  // namespace

std::vector<Attribute> cornerAttributes(const std::vector<Attribute>& attributes,
                                        const TriangleSoup& soup, double scale,
                                        const PreparedSurface& surface) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const SurfaceMesh& mesh = surface.mesh;
  std::vector<Attribute> result;
  for (const Attribute& attribute : attributes) {
    result.push_back({attribute.name, attribute.width, attribute.isLinear, {}});
    result.back().values.reserve(std::size_t{mesh.halfedgeCount()} * attribute.width);
  }
  for (const Halfedge h : mesh.halfedges()) {
    const Index triangle = surface.inputOfFace[SurfaceMesh::faceOf(h)];
    std::array<Index, 3> inputs{};
    std::array<Vec3, 3> corners;
    std::optional<std::size_t> same;
    std::optional<Shares> shares;
    if (triangle != kNoIndex) {
      const Vec3& place = mesh.position(mesh.from(h));
      for (std::size_t k = 0; k < 3; ++k) {
        inputs[k] = soup.triangles[3 * std::size_t{triangle} + k];
        const double* at = soup.positions.data() + 3 * std::size_t{inputs[k]};
        corners[k] = {scale * at[0], scale * at[1], scale * at[2]};
        if (corners[k].x == place.x && corners[k].y == place.y && corners[k].z == place.z) same = k;
      }
      if (!same) shares = sharesIn(corners, place);
    }
    for (std::size_t a = 0; a < attributes.size(); ++a) {
      const Index width = attributes[a].width;
      for (Index i = 0; i < width; ++i) {
        const auto value = [&](std::size_t k) {
          const std::vector<Index>& of = attributes[a].corners;
          const Index number = of.empty() ? inputs[k] : of[3 * std::size_t{triangle} + k];
          return number == kNoIndex ? kNone : attributes[a].values[std::size_t{number} * width + i];
        };
        double sum = kNone;
        if (same) {
          sum = value(*same);
        } else if (shares) {
          sum = 0;
          for (std::size_t k = 0; k < 3; ++k) sum += (*shares)[k] * value(k);
        }
        result[a].values.push_back(sum);
      }
    }
  }
  return result;
}

}  // namespace girth::io
