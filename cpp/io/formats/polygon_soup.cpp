#include "formats/polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/polygon.h"

namespace girth::io {

bool PolygonSoup::endPolygon() {
  const std::size_t count = corners_.size() - begin_;
  if (count < 3) {
    corners_.resize(begin_);
    values_.resize(std::min(values_.size(), begin_));
    leftOut_.push_back(polygons_);
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

std::optional<PolygonSoup::Use> PolygonSoup::firstNowhere(std::span<const double> positions) const {
  std::size_t end = 0, before = 0;
  for (std::size_t polygon = 0, i = 0; polygon < polygons_; ++polygon) {
    end += sizes_.empty() ? 3 : sizes_[polygon];
    while (before < leftOut_.size() && leftOut_[before] <= polygon) ++before;
    for (; i < end; ++i) {
      const auto place = positions.subspan(3 * std::size_t{corners_[i]}, 3);
      if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); })) {
        return Use{corners_[i], polygon + before};
      }
    }
  }
  return std::nullopt;
}

void PolygonSoup::noteLeftOut(std::vector<std::string>& notes) const {
  if (leftOut_.empty()) return;
  const std::size_t count = leftOut_.size();
  notes.push_back(std::to_string(count) + (count == 1 ? " face" : " faces") +
                  " with fewer than three corners " + (count == 1 ? "was" : "were") + " left out.");
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
