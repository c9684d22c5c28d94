#include "mesh/prepare/least_area.h"

#include <utility>

#include "infinity.h"
#include "mesh/face_shape.h"

namespace girth::prepare {

std::optional<Triangulation> leastAreaTriangulation(
    std::span<const Vec3> polygon, const std::function<bool(std::size_t, std::size_t)>& mayJoin,
    const std::function<bool(std::size_t, std::size_t, std::size_t)>& mayUse) {
  // By the parts from corner i to corner j.
  const std::size_t n = polygon.size();
  std::vector<double> least(n * n, 0);
  std::vector<std::size_t> apex(n * n, 0);
  for (std::size_t width = 2; width < n; ++width) {
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      double best = kInfinity;
      // The last one is a side of the polygon.
      if (width + 1 == n || mayJoin(i, j)) {
        for (std::size_t k = i + 1; k < j; ++k) {
          const double parts = least[i * n + k] + least[k * n + j];
          if (!(parts < best)) continue;
          const FaceShape shape({polygon[i], polygon[k], polygon[j]});
          if (!shape.hasArea()) continue;
          const double area = parts + shape.doubleArea / 2;
          if (!(area < best) || (mayUse && !mayUse(i, k, j))) continue;
          best = area;
          apex[i * n + j] = k;
        }
      }
      least[i * n + j] = best;
    }
  }
  if (least[n - 1] == kInfinity) return std::nullopt;
  Triangulation result{least[n - 1], {}};
  std::vector<std::pair<std::size_t, std::size_t>> todo{{0, n - 1}};
  while (!todo.empty()) {
    const auto [i, j] = todo.back();
    todo.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = apex[i * n + j];
    result.triangles.push_back({i, k, j});
    todo.emplace_back(k, j);
    todo.emplace_back(i, k);
  }
  return result;
}

}  // namespace girth::prepare
