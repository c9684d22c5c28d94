#include "mesh/prepare/weld_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "mesh/vector.h"

namespace girth::prepare {

namespace {

std::uint64_t bitsOf(double x) {
  x += 0.0;  // −0 becomes 0
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

std::uint64_t hashOf(double x, double y, double z) {
  std::uint64_t hash = 0;
  for (const double c : {x, y, z}) {
    hash = (hash ^ bitsOf(c)) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  return hash * 0xD6E8FEB86659FD93ull;
}

/// The buckets of a hash: as many as there are entries, rounded up to a power of two.
int bucketBits(std::size_t entries) {
  int bits = 1;
  while (bits < 30 && (std::size_t{1} << bits) < entries) ++bits;
  return bits;
}

}  // namespace

std::vector<Index> firstAtSamePlace(std::span<const double> positions,
                                    std::span<const Index> triangles) {
  const auto vertices = static_cast<Index>(positions.size() / 3);
  std::vector<Index> first(vertices, kNoIndex);
  for (const Index v : triangles) first[v] = v;

  const int shift = 64 - bucketBits(vertices);
  const auto place = [&](Index v) { return &positions[3 * std::size_t{v}]; };
  const auto bucketOf = [&](Index v) {
    return static_cast<std::size_t>(hashOf(place(v)[0], place(v)[1], place(v)[2]) >> shift);
  };
  std::vector<Index> begin((std::size_t{1} << (64 - shift)) + 1, 0);
  Index used = 0;
  for (Index v = 0; v < vertices; ++v) {
    if (first[v] == kNoIndex) continue;
    ++begin[bucketOf(v)];
    ++used;
  }
  Index sum = 0;
  for (Index& entry : begin) {
    sum += entry;
    entry = sum;
  }
  std::vector<Index> order(used);
  for (Index v = vertices; v-- > 0;) {
    if (first[v] != kNoIndex) order[--begin[bucketOf(v)]] = v;
  }

  const auto before = [&](Index a, Index b) {
    for (int k = 0; k < 3; ++k) {
      if (place(a)[k] != place(b)[k]) return place(a)[k] < place(b)[k];
    }
    return a < b;
  };
  for (std::size_t bucket = 0; bucket + 1 < begin.size(); ++bucket) {
    const Index from = begin[bucket], to = begin[bucket + 1];
    if (to - from < 2) continue;
    std::sort(order.begin() + from, order.begin() + to, before);
    for (Index i = from + 1; i < to; ++i) {
      if (std::equal(place(order[i]), place(order[i]) + 3, place(order[i - 1]))) {
        first[order[i]] = first[order[i - 1]];
      }
    }
  }
  return first;
}

void joinWithin(double distance, std::span<const double> positions, std::vector<Index>& first) {
  const auto vertices = static_cast<Index>(first.size());
  double extent = 0;
  for (Index v = 0; v < vertices; ++v) {
    if (first[v] != v) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      extent = std::max(extent, std::fabs(positions[3 * std::size_t{v} + k]));
    }
  }
  // Cells of a power of two of at least the distance: dividing by it is exact. Distances that lie
  // so far below the coordinates' own spacing join nothing.
  int exponent = 0;
  std::frexp(distance, &exponent);
  int largest = 0;
  std::frexp(extent, &largest);
  if (largest - exponent > 900) return;
  using Cell = std::array<double, 3>;
  // In two factors, neither of which overflows.
  const double shrink = std::ldexp(1.0, -(exponent / 2));
  const double shrinkMore = std::ldexp(1.0, -(exponent - exponent / 2));
  const auto scaled = [&](Index v) {
    const double* p = &positions[3 * std::size_t{v}];
    return Cell{p[0] * shrink * shrinkMore, p[1] * shrink * shrinkMore, p[2] * shrink * shrinkMore};
  };
  const auto cellAt = [&](Index v) {
    const Cell p = scaled(v);
    return Cell{std::floor(p[0]), std::floor(p[1]), std::floor(p[2])};
  };
  const double reach = distance * shrink * shrinkMore;

  // The cells in order, and for each a chain of those in it that stand for themselves: a few, as
  // they keep their distance.
  std::vector<Cell> cells;
  for (Index v = 0; v < vertices; ++v) {
    if (first[v] == v) cells.push_back(cellAt(v));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Index> head(cells.size(), kNoIndex), next(vertices, kNoIndex);
  const auto lowerBound = [&](const Cell& cell) {
    return static_cast<std::size_t>(std::lower_bound(cells.begin(), cells.end(), cell) -
                                    cells.begin());
  };

  for (Index v = 0; v < vertices; ++v) {
    if (first[v] == kNoIndex) continue;
    if (first[v] != v) {
      first[v] = first[first[v]];
      continue;
    }
    const Cell p = scaled(v), own = cellAt(v);
    Index nearest = kNoIndex;
    double nearestDistance = reach;
    for (int i = 0; i < 9; ++i) {
      const int column = i % 3 - 1, row = i / 3 - 1;
      const double x = own[0] + column, y = own[1] + row;
      const Cell last{x, y, own[2] + 1};
      for (std::size_t c = lowerBound({x, y, own[2] - 1}); c < cells.size() && cells[c] <= last;
           ++c) {
        for (Index other = head[c]; other != kNoIndex; other = next[other]) {
          const Cell q = scaled(other);
          const double away = norm({p[0] - q[0], p[1] - q[1], p[2] - q[2]});
          if (away < nearestDistance || (away == nearestDistance && other < nearest)) {
            nearest = other;
            nearestDistance = away;
          }
        }
      }
    }
    if (nearest != kNoIndex) {
      first[v] = nearest;
    } else {
      const std::size_t cell = lowerBound(own);
      next[v] = head[cell];
      head[cell] = v;
    }
  }
}

}  // namespace girth::prepare
