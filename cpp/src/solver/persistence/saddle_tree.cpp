#include "solver/persistence/saddle_tree.h"

#include <algorithm>
#include <numeric>

#include "infinity.h"

namespace girth {

namespace {

constexpr double kNoMaximum = -1;

/// Disjoint sets of numbers.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t part, std::size_t whole) { parent_[part] = whole; }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<double> saddleDeaths(std::span<const SaddleEnds> saddles,
                                 std::span<const LocalMaximum> maxima,
                                 std::span<const BentPath> boundaries, bool complete) {
  const std::size_t count = saddles.size();
  std::vector<double> deaths(count, kInfinity);
  if (count == 0) return deaths;

  // The rim: end 2 i is the one half of saddle i, 2 i + 1 the other. Arc k lies to the left of the
  // end at place k.
  const auto pathTo = [&](std::size_t end) -> const BentPath& {
    const SaddleEnds& saddle = saddles[end / 2];
    return end % 2 == 0 ? saddle.there : saddle.back;
  };
  std::vector<std::size_t> order(2 * count), place(2 * count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return leavesRightOf(pathTo(a), pathTo(b));
  });
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  const auto leftOf = [&](std::size_t end) { return place[end]; };
  const auto rightOf = [&](std::size_t end) {
    return (place[end] + order.size() - 1) % order.size();
  };

  Sets pieces(order.size());
  const auto glue = [&](std::size_t a, std::size_t b) {
    pieces.join(pieces.find(a), pieces.find(b));
  };
  for (std::size_t i = 0; i < count; ++i) {
    glue(leftOf(2 * i), rightOf(2 * i + 1));
    glue(rightOf(2 * i), leftOf(2 * i + 1));
  }

  std::vector<double> highest(order.size(), kNoMaximum);
  const auto pieceOf = [&](const BentPath& path) {
    const auto after = std::partition_point(order.begin(), order.end(), [&](std::size_t end) {
      return leavesRightOf(pathTo(end), path);
    });
    const auto k = static_cast<std::size_t>(after - order.begin());
    return pieces.find((k + order.size() - 1) % order.size());
  };
  for (const LocalMaximum& maximum : maxima) {
    double& height = highest[pieceOf(maximum.path)];
    height = std::max(height, maximum.distance);
  }
  for (const BentPath& path : boundaries) highest[pieceOf(path)] = kInfinity;
  for (std::size_t arc = 0; arc < order.size(); ++arc) {
    if (pieces.find(arc) != arc || highest[arc] != kNoMaximum || complete) continue;
    highest[arc] = kInfinity;
  }
  if (complete) {
    // Rounding has hidden the maximum of a piece that is no larger than that: it is filled at once.
    for (std::size_t end = 0; end < order.size(); ++end) {
      double& height = highest[pieces.find(leftOf(end))];
      height = std::max(height, saddles[end / 2].height);
    }
  }

  // From the highest saddle down, pieces grow together; of two maxima the lower one is forgotten.
  std::vector<std::size_t> byHeight(count);
  std::iota(byHeight.begin(), byHeight.end(), std::size_t{0});
  std::stable_sort(byHeight.begin(), byHeight.end(), [&](std::size_t a, std::size_t b) {
    return saddles[a].height > saddles[b].height;
  });
  for (const std::size_t i : byHeight) {
    std::size_t lower = pieces.find(leftOf(2 * i)), higher = pieces.find(rightOf(2 * i));
    if (lower == higher) continue;
    if (highest[lower] > highest[higher]) std::swap(lower, higher);
    deaths[i] = highest[lower];
    pieces.join(lower, higher);
  }
  return deaths;
}

}  // namespace girth
