#include "loops/cut/clear_cap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "mesh/box.h"
#include "mesh/face_shape.h"
#include "mesh/prepare/least_area.h"

namespace girth::loops {

std::vector<Vertex> polygonOf(std::span<const std::array<Vertex, 3>> faces) {
  std::set<std::pair<Vertex, Vertex>> sides;
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) sides.emplace(face[k], face[(k + 1) % 3]);
  }
  std::map<Vertex, Vertex> next;
  std::size_t count = 0;
  for (const auto& [from, to] : sides) {
    if (sides.count({to, from}) > 0) continue;
    next[from] = to;
    ++count;
  }
  // A polygon of n corners has n - 2 triangles.
  if (next.size() != count || faces.size() + 2 != count) return {};
  std::vector<Vertex> polygon;
  for (Vertex at = next.begin()->first; polygon.size() < count; at = next[at]) {
    if (!polygon.empty() && at == polygon.front()) return {};
    polygon.push_back(at);
  }
  return polygon;
}

std::optional<std::vector<std::array<Vertex, 3>>> clearCap(std::span<const Vertex> polygon,
                                                           std::span<const Vec3> places,
                                                           std::span<const PlacedFace> others) {
  std::vector<Vec3> corners, scaled;
  double extent = 0;
  for (const Vertex v : polygon) {
    corners.push_back(places[v]);
    extent =
        std::max({extent, std::fabs(places[v].x), std::fabs(places[v].y), std::fabs(places[v].z)});
  }
  const double scale = scaleFor(extent);
  for (const Vec3& p : corners) scaled.push_back({scale * p.x, scale * p.y, scale * p.z});
  const Box around(corners);
  std::vector<std::pair<Box, const PlacedFace*>> near;
  std::set<std::pair<Vertex, Vertex>> joined;
  for (const PlacedFace& face : others) {
    const Box box(face.places);
    if (!box.overlaps(around)) continue;
    near.emplace_back(box, &face);
    for (std::size_t k = 0; k < 3; ++k) {
      joined.insert(std::minmax(face.vertices[k], face.vertices[(k + 1) % 3]));
    }
  }
  const auto found = prepare::leastAreaTriangulation(
      scaled,
      [&](std::size_t i, std::size_t j) {
        return joined.count(std::minmax(polygon[i], polygon[j])) == 0;
      },
      [&](std::size_t i, std::size_t k, std::size_t j) {
        const PlacedFace face{{polygon[i], polygon[k], polygon[j]},
                              {corners[i], corners[k], corners[j]}};
        const Box box(face.places);
        return std::none_of(near.begin(), near.end(), [&](const auto& other) {
          return box.overlaps(other.first) && facesMeet(face, *other.second);
        });
      });
  if (!found) return std::nullopt;
  std::vector<std::array<Vertex, 3>> faces;
  for (const auto& [i, k, j] : found->triangles)
    faces.push_back({polygon[i], polygon[k], polygon[j]});
  return faces;
}

}  // namespace girth::loops
