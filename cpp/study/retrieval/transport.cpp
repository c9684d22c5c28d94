#include "girth/study/transport.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace girth::study {

namespace {

constexpr std::int64_t kWhole = std::int64_t{1} << 40;
constexpr double kGreatestCost = 1 << 30;

/// The shares that are not nothing, in whole numbers that add up to kWhole.
struct Side {
  std::vector<std::size_t> place;
  std::vector<std::int64_t> share;
};

bool wholeShares(std::span<const double> masses, Side& side) {
  double sum = 0;
  for (const double mass : masses) {
    if (!(mass >= 0) || !std::isfinite(mass)) return false;
    sum += mass;
  }
  if (!(sum > 0) || !std::isfinite(sum)) return false;
  std::int64_t rest = kWhole;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const auto share =
        static_cast<std::int64_t>(std::llround(masses[i] / sum * static_cast<double>(kWhole)));
    if (share == 0) continue;
    side.place.push_back(i);
    side.share.push_back(share);
    rest -= share;
  }
  // The rest that rounding left is too little to change the greatest.
  *std::max_element(side.share.begin(), side.share.end()) += rest;
  return true;
}

/// A spanning tree of sources, sinks and a root, with the flow on each node's arc to its parent.
/// Arcs of the root are artificial: dearer than any way through the others.
class NetworkSimplex {
 public:
  NetworkSimplex(const Side& sources, const Side& sinks, const std::vector<std::int64_t>& costs)
      : sources_(sources.share.size()),
        sinks_(sinks.share.size()),
        costs_(costs),
        nodes_(sources_ + sinks_ + 1) {
    const Node root = sources_ + sinks_;
    const std::int64_t dear =
        static_cast<std::int64_t>(kGreatestCost) * static_cast<std::int64_t>(root + 1);
    for (Node node = 0; node < root; ++node) {
      const bool source = node < sources_;
      TreeNode& entry = nodes_[node];
      entry.parent = root;
      entry.up = source;
      entry.flow = source ? sources.share[node] : sinks.share[node - sources_];
      entry.potential = source ? -dear : dear;
      entry.depth = 1;
      link(node, root);
    }
  }

  void solve() {
    std::size_t arc = 0;
    while (findEntering(arc)) pivot(arc);
  }

  /// Calls `use(source, sink, flow)` for all arcs that carry something.
  template <class Use>
  void forEachFlow(Use use) const {
    for (Node node = 0; node + 1 < nodes_.size(); ++node) {
      const TreeNode& entry = nodes_[node];
      if (entry.flow == 0 || entry.parent == nodes_.size() - 1) continue;
      const Node source = entry.up ? node : entry.parent;
      const Node sink = entry.up ? entry.parent : node;
      use(source, sink - sources_, entry.flow);
    }
  }

 private:
  using Node = std::size_t;
  static constexpr Node kNone = static_cast<Node>(-1);
  struct TreeNode {
    Node parent{kNone}, firstChild{kNone}, before{kNone}, after{kNone};
    std::size_t depth{0};
    std::int64_t flow{0}, potential{0};
    bool up{false};  ///< the arc runs to the parent
  };

  void link(Node node, Node parent) {
    TreeNode& entry = nodes_[node];
    entry.parent = parent;
    entry.before = kNone;
    entry.after = nodes_[parent].firstChild;
    if (entry.after != kNone) nodes_[entry.after].before = node;
    nodes_[parent].firstChild = node;
  }

  void unlink(Node node) {
    const TreeNode& entry = nodes_[node];
    if (entry.before != kNone) {
      nodes_[entry.before].after = entry.after;
    } else {
      nodes_[entry.parent].firstChild = entry.after;
    }
    if (entry.after != kNone) nodes_[entry.after].before = entry.before;
  }

  std::int64_t reducedCost(std::size_t arc) const {
    return costs_[arc] + nodes_[arc / sinks_].potential - nodes_[sources_ + arc % sinks_].potential;
  }

  /// The arc of the most negative reduced cost in the first block of arcs that has one, going on
  /// from where the last search ended.
  bool findEntering(std::size_t& arc) {
    const auto block =
        static_cast<std::size_t>(std::max(10.0, std::sqrt(static_cast<double>(costs_.size()))));
    std::int64_t least = 0;
    std::size_t untilCheck = block;
    for (std::size_t seen = 0; seen < costs_.size(); ++seen) {
      if (++next_ >= costs_.size()) next_ = 0;
      const std::int64_t cost = reducedCost(next_);
      if (cost < least) {
        least = cost;
        arc = next_;
      }
      if (--untilCheck > 0) continue;
      if (least < 0) return true;
      untilCheck = block;
    }
    return least < 0;
  }

  void pivot(std::size_t arc) {
    const Node u = arc / sinks_, v = sources_ + arc % sinks_;
    // The cycle: from its top down to u, over the arc to v, and up again.
    Node a = u, b = v;
    while (a != b) {
      if (nodes_[a].depth >= nodes_[b].depth) {
        a = nodes_[a].parent;
      } else {
        b = nodes_[b].parent;
      }
    }
    const Node top = a;
    // The last arc on the way round that loses flow and has the least leaves: this keeps
    // the tree strongly feasible, and so no sequence of pivots repeats.
    std::int64_t least = INT64_MAX;
    Node leaving = kNone;
    bool onSideOfU = true;
    for (Node node = u; node != top; node = nodes_[node].parent) {
      if (nodes_[node].up && nodes_[node].flow < least) {
        least = nodes_[node].flow;
        leaving = node;
      }
    }
    for (Node node = v; node != top; node = nodes_[node].parent) {
      if (!nodes_[node].up && nodes_[node].flow <= least) {
        least = nodes_[node].flow;
        leaving = node;
        onSideOfU = false;
      }
    }
    for (Node node = u; node != top; node = nodes_[node].parent) {
      nodes_[node].flow += nodes_[node].up ? -least : least;
    }
    for (Node node = v; node != top; node = nodes_[node].parent) {
      nodes_[node].flow += nodes_[node].up ? least : -least;
    }
    const std::int64_t cost = reducedCost(arc);
    hang(onSideOfU ? u : v, onSideOfU ? v : u, leaving, onSideOfU, least);
    shift(onSideOfU ? u : v, onSideOfU ? -cost : cost);
  }

  /// Cuts the subtree of `leaving` off and hangs it, by its node `node`, under `parent`.
  void hang(Node node, Node parent, Node leaving, bool up, std::int64_t flow) {
    for (bool done = false; !done;) {
      const Node oldParent = nodes_[node].parent;
      const bool oldUp = nodes_[node].up;
      const std::int64_t oldFlow = nodes_[node].flow;
      done = node == leaving;
      unlink(node);
      link(node, parent);
      nodes_[node].up = up;
      nodes_[node].flow = flow;
      // Its old parent becomes its child, over the same arc.
      parent = node;
      node = oldParent;
      up = !oldUp;
      flow = oldFlow;
    }
  }

  /// Depths and potentials of a subtree after it was hung elsewhere.
  void shift(Node subtree, std::int64_t change) {
    stack_.assign(1, subtree);
    while (!stack_.empty()) {
      const Node node = stack_.back();
      stack_.pop_back();
      nodes_[node].depth = nodes_[nodes_[node].parent].depth + 1;
      nodes_[node].potential += change;
      for (Node child = nodes_[node].firstChild; child != kNone; child = nodes_[child].after) {
        stack_.push_back(child);
      }
    }
  }

  std::size_t sources_, sinks_;
  const std::vector<std::int64_t>& costs_;
  std::vector<TreeNode> nodes_;
  std::vector<Node> stack_;
  std::size_t next_{0};
};

Error refused(const char* what) { return makeError(ErrorCode::InvalidOption, -1, what); }

}  // namespace

Result<double> transportCost(std::span<const double> supplies, std::span<const double> demands,
                             std::span<const double> costs) {
  if (costs.size() != supplies.size() * demands.size()) {
    return refused("there must be one cost for every source and sink");
  }
  Side sources, sinks;
  if (!wholeShares(supplies, sources) || !wholeShares(demands, sinks)) {
    return refused("supplies and demands must be finite, not negative, and not all zero");
  }
  double greatest = 0;
  for (const double cost : costs) {
    if (!(cost >= 0) || !std::isfinite(cost)) return refused("a cost is negative or not finite");
    greatest = std::max(greatest, cost);
  }
  if (greatest == 0) return 0.0;
  const auto costOf = [&](std::size_t i, std::size_t j) {
    return costs[sources.place[i] * demands.size() + sinks.place[j]];
  };
  std::vector<std::int64_t> whole;
  whole.reserve(sources.place.size() * sinks.place.size());
  for (std::size_t i = 0; i < sources.place.size(); ++i) {
    for (std::size_t j = 0; j < sinks.place.size(); ++j) {
      whole.push_back(std::llround(costOf(i, j) / greatest * kGreatestCost));
    }
  }
  NetworkSimplex simplex(sources, sinks, whole);
  simplex.solve();
  double total = 0;
  simplex.forEachFlow([&](std::size_t source, std::size_t sink, std::int64_t flow) {
    total += costOf(source, sink) * (static_cast<double>(flow) / static_cast<double>(kWhole));
  });
  return total;
}

}  // namespace girth::study
