// Lowest ways on a function that is known everywhere: searches end, at the height of a way.
#include "loops/necks/pass_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace girth {
namespace {

constexpr double kLength = 60, kWidth = 3;

/// A ridge across a strip, with an edge on both sides at which the height jumps.
double heightAt(double x, double y) {
  const double ridge = std::fabs(x / kLength - 0.5) < 0.25
                           ? 1 + 0.2 * std::sin(3 * y + 2) + 0.3 * std::sin(1.7 * x * y + 2)
                           : 0;
  return 10 + ridge + 0.05 * std::sin(13 * x + 7 * y * y);
}

/// The strip in cells that are forty times as long as wide; vertex (i, j) has the number 9 i + j.
SurfaceMesh strip() {
  constexpr Index kColumns = 4, kRows = 8;
  std::vector<double> positions;
  std::vector<Index> triangles;
  for (Index i = 0; i <= kColumns; ++i) {
    for (Index j = 0; j <= kRows; ++j) {
      positions.insert(positions.end(), {kLength * i / kColumns, kWidth * j / kRows, 0});
    }
  }
  for (Index i = 0; i < kColumns; ++i) {
    for (Index j = 0; j < kRows; ++j) {
      const Index a = i * (kRows + 1) + j, b = a + kRows + 1;
      triangles.insert(triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary).value();
}

/// The lowest way along the strip over a grid of points, each with eight neighbours.
double lowestOnGrid(double step) {
  const int columns = static_cast<int>(kLength / step) + 1,
            rows = static_cast<int>(kWidth / step) + 1;
  std::vector<bool> isSettled(static_cast<std::size_t>(columns) * rows, false);
  using Entry = std::pair<double, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int j = 0; j < rows; ++j) queue.push({heightAt(0, step * j), {0, j}});
  while (!queue.empty()) {
    const auto [height, place] = queue.top();
    queue.pop();
    const auto [i, j] = place;
    if (i == columns - 1) return height;
    const auto number = static_cast<std::size_t>(i) * rows + j;
    if (isSettled[number]) continue;
    isSettled[number] = true;
    for (int k = std::max(0, i - 1); k <= i + 1; ++k) {
      for (int l = std::max(0, j - 1); l <= std::min(rows - 1, j + 1); ++l) {
        queue.push({std::max(height, heightAt(step * k, step * l)), {k, l}});
      }
    }
  }
  return 0;
}

TEST(PassSearch, endsWhereHalvesMakeNarrowCells) {
  // Halving segments as they are never comes to an end here: 5000 searches of a way were made.
  const SurfaceMesh mesh = strip();
  std::vector<double> values;
  std::vector<Vertex> starts;
  std::vector<bool> isEnd;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    values.push_back(heightAt(p.x, p.y));
    if (p.x == 0) starts.push_back(v);
    isEnd.push_back(p.x == kLength);
  }
  int rounds = 0;
  loops::PassSearch search(
      mesh, values, [&](std::span<const SurfacePoint> points) -> Result<std::vector<double>> {
        ++rounds;
        std::vector<double> heights;
        for (const SurfacePoint& point : points) {
          const Vec3 p = positionOf(mesh, point);
          heights.push_back(heightAt(p.x, p.y));
        }
        return heights;
      });
  constexpr double kFinest = 0.1;
  const auto height = search.height(starts, isEnd, 9, kFinest);
  ASSERT_TRUE(height.ok());
  EXPECT_LT(rounds, 1000);
  // The height of a way that there is: none is lower than the lowest, nor is one higher than all.
  EXPECT_GE(height.value(), lowestOnGrid(kFinest / 4) - kFinest);
  EXPECT_LE(height.value(), 11.55);
}

}  // namespace
}  // namespace girth
