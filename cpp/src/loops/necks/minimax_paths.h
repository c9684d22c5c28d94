// Minimax paths of a graph: the greatest height on the path is as low as possible. They are found
// again after edges of the graph were divided.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "girth/elements.h"
#include "loops/necks/index_set.h"

namespace girth::loops {

/// A flood settles the nodes in rising order of the least height at which a path leads to them; of
/// nodes with equal heights the least number comes first. A division keeps the part of the order
/// that it does not change.
class MinimaxPaths {
 public:
  /// The graph may grow. `values[n]` is the height of node n, NaN where no path may pass;
  /// `neighbours[n]` are the nodes next to it. Both must outlive this.
  MinimaxPaths(const std::vector<double>& values, const std::vector<std::vector<Index>>& neighbours)
      : values_(values), neighbours_(neighbours) {}

  struct Path {
    double height;             ///< infinite where there is none
    std::vector<Index> nodes;  ///< from the end back to a start
  };

  /// Begins anew from some nodes, at the height `level`. O(nodes).
  void start(std::span<const Index> starts, double level);
  /// The minimax path to a node for which `isEnd` is true; nodes beyond it are no ends. All calls
  /// after a start must have the same ends. O(k log k) for k nodes settled by this call.
  Path to(const std::vector<bool>& isEnd);
  /// The edge from a to b has been replaced by edges of a new node, the last of the graph.
  /// O(k log k) for k nodes whose place in the order may change.
  void onDivision(Index a, Index b, Index node);

 private:
  using Entry = std::pair<double, Index>;

  bool isSettled(Index node) const { return settledAt_[node] != kNoIndex; }
  void fit();
  void enqueue(Index node);
  /// The first in the queue; kNoIndex where there is none.
  Index first();
  void takeOut(Index node);
  void reach(Index node, Index from);
  /// Reaches a node from the first of its neighbours that was settled.
  void reachFromFirst(Index node);
  /// Undoes what was settled from a place in the order on.
  void undo(std::size_t place);
  void dropOutdated();
  /// The edge by which a node may have been reached is gone.
  void leave(Index node, Index from);

  const std::vector<double>& values_;
  const std::vector<std::vector<Index>>& neighbours_;
  std::vector<double> reached_;
  /// The first of its neighbours that was settled: heights rise, so none behind it leads there at
  /// a lower one.
  std::vector<Index> before_;
  std::vector<Index> settledAt_;
  std::vector<Index> settled_;
  // The queue: nodes that are reached at `level_`, and a heap of those at other heights, whose
  // entries may be out of date. Once the lowest pass is behind, all there is lies at one level.
  double level_{0};
  IndexSet atLevel_;
  std::vector<Entry> others_;
};

}  // namespace girth::loops
