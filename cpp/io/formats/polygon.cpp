#include "formats/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace girth::io {
namespace {

// Point-in-triangle tests over a whole file: seconds.
constexpr std::uint64_t kMostWork = 500'000'000;

}  // namespace

/// Drops the coordinate along which the mean normal (Newell) is longest, so that the polygon turns
/// left seen in the plane of the other two.
void PolygonCutter::project(std::span<const double> positions, std::span<const Index> corners) {
  const auto at = [&](std::size_t i, std::size_t k) { return positions[3 * corners[i] + k]; };
  const std::size_t n = corners.size();
  std::array<double, 3> normal{0, 0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      // Relative to the first corner: far from the origin the products would swamp the area.
      const double iu = at(i, u) - at(0, u), iv = at(i, v) - at(0, v);
      const double ju = at(j, u) - at(0, u), jv = at(j, v) - at(0, v);
      normal[k] += iu * jv - iv * ju;
    }
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
  }
  std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  flat_.resize(n);
  for (std::size_t i = 0; i < n; ++i) flat_[i] = {at(i, u) - at(0, u), at(i, v) - at(0, v)};
}

/// Twice the area of the triangle of three corners; positive: a left turn.
double PolygonCutter::turn(std::size_t a, std::size_t b, std::size_t c) const {
  return (flat_[b].u - flat_[a].u) * (flat_[c].v - flat_[a].v) -
         (flat_[b].v - flat_[a].v) * (flat_[c].u - flat_[a].u);
}

bool PolygonCutter::inTriangle(std::size_t point, std::size_t a, std::size_t b,
                               std::size_t c) const {
  // A corner that stands where another stands (as at a bridge to a hole) does not block.
  for (const std::size_t corner : {a, b, c}) {
    if (flat_[point].u == flat_[corner].u && flat_[point].v == flat_[corner].v) return false;
  }
  return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
}

bool PolygonCutter::cut(std::span<const double> positions, std::span<const Index> corners,
                        std::vector<Index>& triangles) {
  const auto emit = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.insert(triangles.end(),
                     {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
  };
  const std::size_t n = corners.size();
  if (n == 3) {
    emit(0, 1, 2);
    return true;
  }
  project(positions, corners);
  if (n == 4) {
    const auto squared = [&](std::size_t a, std::size_t b) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = positions[3 * corners[a] + k] - positions[3 * corners[b] + k];
        sum += d * d;
      }
      return sum;
    };
    const bool inside02 = turn(0, 1, 2) > 0 && turn(0, 2, 3) > 0;
    const bool inside13 = turn(0, 1, 3) > 0 && turn(1, 2, 3) > 0;
    if (inside13 && (!inside02 || squared(1, 3) < squared(0, 2))) {
      emit(0, 1, 3);
      emit(1, 2, 3);
    } else {
      emit(0, 1, 2);
      emit(0, 2, 3);
    }
    return true;
  }

  // Ear clipping.
  left_.resize(n);
  for (std::size_t i = 0; i < n; ++i) left_[i] = i;
  std::size_t at = 0;
  std::size_t refused = 0;
  while (left_.size() > 3) {
    if (work_ > kMostWork) return false;
    const std::size_t m = left_.size();
    const std::size_t before = left_[(at + m - 1) % m], here = left_[at % m];
    const std::size_t after = left_[(at + 1) % m];
    bool ear = turn(before, here, after) > 0;
    for (std::size_t i = 0; i + 3 < m && ear; ++i) {
      ++work_;
      ear = !inTriangle(left_[(at + 2 + i) % m], before, here, after);
    }
    // Where a whole round finds no ear the polygon crosses itself or is flat: cut all the same.
    if (!ear && refused < m) {
      ++refused;
      at = (at + 1) % m;
      continue;
    }
    emit(before, here, after);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at % m));
    work_ += m / 16 + 1;
    // After an erased corner `at` is the next one; its neighbour in turn is not an ear's tip again
    // at once, which spreads the cuts round the polygon.
    at = (at + 1) % left_.size();
    refused = 0;
  }
  emit(left_[0], left_[1], left_[2]);
  return true;
}

}  // namespace girth::io
