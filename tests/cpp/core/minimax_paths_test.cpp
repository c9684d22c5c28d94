// Floods that are kept while edges are divided, beside floods from the start.
#include "loops/necks/minimax_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <random>

namespace {

using girth::Index;
using girth::kNoIndex;
using girth::loops::MinimaxPaths;

struct Graph {
  std::vector<double> values;
  std::vector<std::vector<Index>> neighbours;

  void join(Index a, Index b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  /// Puts a node into an edge, and joins it to a node on each side, as dividing two triangles does.
  void divide(Index a, Index b, double value) {
    std::erase(neighbours[a], b);
    std::erase(neighbours[b], a);
    const auto node = static_cast<Index>(values.size());
    values.push_back(value);
    neighbours.emplace_back();
    for (const Index beside : neighbours[a]) {
      if (std::count(neighbours[b].begin(), neighbours[b].end(), beside) > 0) join(node, beside);
    }
    join(node, a);
    join(node, b);
  }
};

/// A path by its definition: every node settled in the order of height and number.
MinimaxPaths::Path fromTheStart(const Graph& graph, const std::vector<Index>& starts, double level,
                                const std::vector<bool>& isEnd) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> reached(graph.values.size(), kInfinity);
  std::vector<Index> before(graph.values.size(), kNoIndex);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index node, double height, Index from) {
    if (!(height < reached[node])) return;
    reached[node] = height;
    before[node] = from;
    queue.emplace(height, node);
  };
  for (const Index node : starts) reach(node, level, kNoIndex);
  while (!queue.empty()) {
    const auto [height, node] = queue.top();
    queue.pop();
    if (height > reached[node]) continue;
    if (node < isEnd.size() && isEnd[node]) {
      MinimaxPaths::Path way{height, {}};
      for (Index at = node; at != kNoIndex; at = before[at]) way.nodes.push_back(at);
      return way;
    }
    for (const Index next : graph.neighbours[node]) {
      if (graph.values[next] < kInfinity) {
        reach(next, std::max(height, graph.values[next]), node);
      }
    }
  }
  return {kInfinity, {}};
}

/// A grid of triangles with heights of a few levels, so that many are equal, and some places
/// without one.
Graph grid(Index side, std::mt19937& random) {
  Graph graph;
  std::uniform_int_distribution<int> level(0, 12);
  for (Index i = 0; i < side * side; ++i) {
    const int height = level(random);
    graph.values.push_back(height == 12 ? std::numeric_limits<double>::quiet_NaN() : height);
    graph.neighbours.emplace_back();
  }
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      const Index at = y * side + x;
      if (x + 1 < side) graph.join(at, at + 1);
      if (y + 1 < side) graph.join(at, at + side);
      if (x + 1 < side && y + 1 < side) graph.join(at, at + side + 1);
    }
  }
  return graph;
}

TEST(MinimaxPaths, AreThoseOfAFloodFromTheStartAfterEveryDivision) {
  std::mt19937 random(7);
  std::size_t found = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Graph graph = grid(9, random);
    MinimaxPaths ways(graph.values, graph.neighbours);
    const auto pick = [&](std::size_t below) {
      return static_cast<Index>(std::uniform_int_distribution<std::size_t>(0, below - 1)(random));
    };
    for (int search = 0; search < 3; ++search) {
      const std::vector<Index> starts{pick(81), pick(81)};
      std::vector<bool> isEnd(81, false);
      isEnd[pick(81)] = true;
      isEnd[pick(81)] = true;
      const double level = pick(8);
      ways.start(starts, level);
      for (int round = 0; round < 12; ++round) {
        const MinimaxPaths::Path expected = fromTheStart(graph, starts, level, isEnd);
        const MinimaxPaths::Path way = ways.to(isEnd);
        ASSERT_EQ(way.height, expected.height) << trial << ' ' << search << ' ' << round;
        ASSERT_EQ(way.nodes, expected.nodes) << trial << ' ' << search << ' ' << round;
        if (way.nodes.size() > 1) ++found;
        // Edges of the way, and others anywhere.
        for (int k = 0; k < 4; ++k) {
          Index a = pick(graph.values.size());
          if (k % 2 == 0 && way.nodes.size() > 1) a = way.nodes[pick(way.nodes.size())];
          if (graph.neighbours[a].empty()) continue;
          const Index b = graph.neighbours[a][pick(graph.neighbours[a].size())];
          graph.divide(a, b, pick(26) / 2.0);
          ways.onDivision(a, b, static_cast<Index>(graph.values.size() - 1));
        }
      }
    }
  }
  EXPECT_GT(found, 1000U);
}

TEST(MinimaxPaths, HaveNoNodesWhereNoWayLeads) {
  Graph graph;
  graph.values = {1, 1, 1};
  graph.neighbours.resize(3);
  graph.join(0, 1);
  MinimaxPaths ways(graph.values, graph.neighbours);
  const std::vector<Index> starts{0};
  ways.start(starts, 1);
  const MinimaxPaths::Path way = ways.to({false, false, true});
  EXPECT_EQ(way.height, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(way.nodes.empty());
}

}  // namespace
