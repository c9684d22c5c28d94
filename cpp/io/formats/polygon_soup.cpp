#include "formats/polygon_soup.h"

#include <algorithm>
#include <utility>

#include "formats/polygon.h"

namespace girth::io {

bool PolygonSoup::endPolygon() {
  const std::size_t count = corners_.size() - begin_;
  if (count < 3) {
    corners_.resize(begin_);
    values_.resize(std::min(values_.size(), begin_));
    return false;
  }
  if (count != 3 && sizes_.empty()) sizes_.assign(polygons_, 3);
  if (count != 3 || !sizes_.empty()) sizes_.push_back(static_cast<Index>(count));
  ++polygons_;
  begin_ = corners_.size();
  return true;
}

std::optional<PolygonSoup::Corner> PolygonSoup::firstOutside(std::size_t vertices) const {
  for (const Corner& corner : ahead_) {
    if (corner.vertex >= vertices) return corner;
  }
  return std::nullopt;
}

std::optional<std::vector<Index>> PolygonSoup::takeTriangles(std::span<const double> positions) {
  std::vector<Index> corners = std::exchange(corners_, {});
  const std::vector<Index> sizes = std::exchange(sizes_, {});
  const std::size_t polygons = std::exchange(polygons_, 0);
  begin_ = 0;
  ahead_.clear();
  if (!values_.empty()) values_.resize(corners.size(), kNoIndex);
  if (sizes.empty()) return corners;
  const std::vector<Index> values = std::exchange(values_, {});
  std::vector<Index> triangles;
  triangles.reserve(3 * (corners.size() - 2 * polygons));
  if (!values.empty()) values_.reserve(3 * (corners.size() - 2 * polygons));
  PolygonCutter cutter;
  std::size_t first = 0;
  for (const Index size : sizes) {
    const std::size_t begin = triangles.size();
    if (!cutter.cut(positions, std::span(corners).subspan(first, size), triangles)) {
      return std::nullopt;
    }
    for (std::size_t i = begin; i < triangles.size(); ++i) {
      const std::size_t corner = first + triangles[i];
      if (!values.empty()) values_.push_back(values[corner]);
      triangles[i] = corners[corner];
    }
    first += size;
  }
  return triangles;
}

}  // namespace girth::io
