#include "mesh/space_filling_curve.h"

#include <algorithm>
#include <utility>

namespace girth {

std::vector<Index> alongCurve(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const auto cell = [&](double x, double start) {
    return extent > 0 ? static_cast<std::uint64_t>((x - start) / extent * 0x1FFFFF) : 0;
  };
  const auto spread = [](std::uint64_t x) {  // 21 bits, two zeros after each
    x = (x | x << 32) & 0x1F00000000FFFFull;
    x = (x | x << 16) & 0x1F0000FF0000FFull;
    x = (x | x << 8) & 0x100F00F00F00F00Full;
    x = (x | x << 4) & 0x10C30C30C30C30C3ull;
    return (x | x << 2) & 0x1249249249249249ull;
  };
  std::vector<std::pair<std::uint64_t, Index>> curve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    curve[i] = {
        spread(cell(p.x, low.x)) | spread(cell(p.y, low.y)) << 1 | spread(cell(p.z, low.z)) << 2,
        i};
  }
  std::sort(curve.begin(), curve.end());
  std::vector<Index> order(points.size());
  for (Index i = 0; i < points.size(); ++i) order[i] = curve[i].second;
  return order;
}

}  // namespace girth
