#include "analysis/tubes/tube_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "analysis/tubes/tube_ends.h"
#include "mesh/vector.h"
#include "no_value.h"
#include "spectral/harmonic.h"

namespace girth::tubes {
namespace {

/// Levels of a branch at equal steps of the function, and as many again at equal numbers of
/// vertices.
constexpr std::size_t kLevels = 64;
/// Levels of a branch nearer to each other than this share of its height are one.
constexpr double kSameLevel = 1e-6;

/// Joins vertices from the highest to the lowest: where two branches meet, a third begins.
class BranchSearch {
 public:
  BranchSearch(const SurfaceMesh& mesh, const std::vector<TreeEnd>& ends,
               std::span<const double> values)
      : mesh_(mesh),
        values_(values),
        setOf_(mesh.vertexCount(), kNoIndex),
        pieceOf_(mesh.vertexCount(), kNoIndex),
        pieceOfSet_(mesh.vertexCount(), kNoIndex),
        lowest_(mesh.componentCount(), kNoIndex) {
    // The first end of each component is its lowest place.
    Index component = kNoIndex;
    for (Index i = 0; i < ends.size(); ++i) {
      const bool isLowest = ends[i].component != component;
      component = ends[i].component;
      if (isLowest) {
        lowest_[component] = i;
        continue;
      }
      const Index piece = begin(component, i, values[ends[i].vertices.front()]);
      for (const Vertex v : ends[i].vertices) place(v, piece);
    }
  }

  void run() {
    std::vector<Vertex> order;
    for (const Vertex v : mesh_.vertices()) {
      if (!std::isnan(values_[v])) order.push_back(v);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](Vertex a, Vertex b) { return values_[a] > values_[b]; });
    for (const Vertex v : order) join(v);
  }

  /// The branches by component, each behind its parent, and for each vertex the one it lies on.
  std::pair<std::vector<TreeBranch>, std::vector<Index>> result() {
    std::vector<Index> order;
    for (Index p = 0; p < pieces_.size(); ++p) {
      if (pieces_[p].isBranch) order.push_back(p);
    }
    // A branch is made behind all that end in it.
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      const Index one = pieces_[a].branch.component, other = pieces_[b].branch.component;
      return one != other ? one < other : a > b;
    });
    std::vector<Index> numberOf(pieces_.size(), kNoIndex);
    std::vector<TreeBranch> branches;
    for (const Index p : order) {
      TreeBranch& branch = pieces_[p].branch;
      if (pieces_[p].next != kNoIndex) {
        branch.parent = numberOf[pieces_[p].next];
      } else {
        branch.bottom = lowest_[branch.component];
      }
      numberOf[p] = static_cast<Index>(branches.size());
      branches.push_back(std::move(branch));
    }
    std::vector<Index> branchOf(mesh_.vertexCount(), kNoIndex);
    for (const Vertex v : mesh_.vertices()) {
      Index piece = pieceOf_[v];
      while (piece != kNoIndex && !pieces_[piece].isBranch) piece = pieces_[piece].next;
      if (piece != kNoIndex) branchOf[v] = numberOf[piece];
    }
    return {std::move(branches), std::move(branchOf)};
  }

 private:
  /// A branch, or a bump that leads to no end and belongs to what it grows out of.
  struct Piece {
    bool isBranch{false};
    Index next{kNoIndex};  ///< the piece that it ends in
    TreeBranch branch;
  };

  Index begin(Index component, Index end, double value) {
    const auto piece = static_cast<Index>(pieces_.size());
    pieces_.push_back({true, kNoIndex, {component, kNoIndex, end, kNoIndex, 0, value, {}}});
    return piece;
  }

  /// The vertex that stands for the joined ones around it.
  Index find(Index v) {
    while (setOf_[v] != v) v = setOf_[v] = setOf_[setOf_[v]];
    return v;
  }

  void place(Vertex v, Index piece) {
    pieceOf_[v] = piece;
    setOf_[v] = v;
    pieceOfSet_[v] = piece;
  }

  void join(Vertex v) {
    std::vector<Index> sets;
    const auto add = [&](Index set) {
      if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
    };
    if (setOf_[v] != kNoIndex) add(find(v));
    const Halfedge first = mesh_.outgoing(v);
    for (Halfedge h = first; h != Halfedge::none;) {
      const Halfedge before = SurfaceMesh::previous(h);
      for (const Vertex other : {mesh_.to(h), mesh_.from(before)}) {
        if (setOf_[other] != kNoIndex) add(find(other));
      }
      h = mesh_.twin(before);
      if (h == first) break;
    }
    std::vector<Index> branches;
    for (const Index set : sets) {
      const Index piece = pieceOfSet_[set];
      const bool isNew = std::find(branches.begin(), branches.end(), piece) == branches.end();
      if (pieces_[piece].isBranch && isNew) branches.push_back(piece);
    }
    Index piece = kNoIndex;
    if (branches.size() > 1) {
      piece = begin(mesh_.componentOf(v), kNoIndex, values_[v]);
      for (const Index one : branches) {
        pieces_[one].branch.low = values_[v];
        pieces_[one].next = piece;
      }
    } else if (branches.size() == 1) {
      piece = branches.front();
    } else if (!sets.empty()) {
      piece = pieceOfSet_[sets.front()];
    } else {
      piece = static_cast<Index>(pieces_.size());
      pieces_.emplace_back();
    }
    for (const Index set : sets) {
      const Index other = pieceOfSet_[set];
      if (other != piece && !pieces_[other].isBranch) pieces_[other].next = piece;
    }
    if (setOf_[v] == kNoIndex) {
      setOf_[v] = v;
      pieceOf_[v] = piece;
    }
    const Index all = find(v);
    for (const Index set : sets) setOf_[set] = all;
    pieceOfSet_[all] = piece;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> values_;
  std::vector<Index> setOf_;       // by vertex; none: not joined yet
  std::vector<Index> pieceOf_;     // by vertex: what it joined
  std::vector<Index> pieceOfSet_;  // by the vertex that stands for a set
  std::vector<Index> lowest_;      // by component: its first end
  std::vector<Piece> pieces_;
};

/// The levels at which a branch is cut. `values`: of its vertices.
std::vector<TreeLevel> levelsOf(const TreeBranch& branch, std::vector<double> values) {
  std::vector<double> levels;
  const double height = branch.high - branch.low;
  for (std::size_t i = 0; i < kLevels; ++i) {
    levels.push_back(branch.low + (static_cast<double>(i) + 0.5) / kLevels * height);
  }
  std::sort(values.begin(), values.end());
  for (std::size_t i = 0; i < kLevels && values.size() > 1; ++i) {
    const std::size_t place = (2 * i + 1) * (values.size() - 1) / (2 * kLevels);
    levels.push_back((values[place] + values[place + 1]) / 2);
  }
  std::sort(levels.begin(), levels.end());
  std::vector<TreeLevel> all;
  for (const double level : levels) {
    const bool isInside = level > branch.low && level < branch.high;
    if (!isInside || (!all.empty() && level - all.back().value < kSameLevel * height)) continue;
    all.push_back({level, 0, {}});
  }
  return all;
}

/// Measures the level curves of all branches.
void measureLevels(const SurfaceMesh& mesh, std::span<const double> values, TubeTree& tree) {
  for (const Face f : mesh.faces()) {
    const std::array<Vertex, 3> corners = mesh.faceVertices(f);
    const auto [lowest, highest] =
        std::minmax({corners[0], corners[1], corners[2]},
                    [&](Vertex a, Vertex b) { return values[a] < values[b]; });
    Index b = tree.branchOfVertex[highest];
    for (; b != kNoIndex; b = tree.branches[b].parent) {
      TreeBranch& branch = tree.branches[b];
      const auto first = std::upper_bound(
          branch.levels.begin(), branch.levels.end(), values[lowest],
          [](double value, const TreeLevel& level) { return value < level.value; });
      for (auto level = first; level != branch.levels.end() && level->value <= values[highest];
           ++level) {
        std::array<Vec3, 2> ends;
        std::size_t found = 0;
        for (std::size_t k = 0; k < 3 && found < 2; ++k) {
          const Vertex from = corners[k], to = corners[(k + 1) % 3];
          if ((values[from] < level->value) == (values[to] < level->value)) continue;
          const double share = (level->value - values[from]) / (values[to] - values[from]);
          ends[found++] = mesh.position(from) + share * (mesh.position(to) - mesh.position(from));
        }
        const double length = norm(ends[1] - ends[0]);
        level->length += length;
        level->centre = level->centre + (length / 2) * (ends[0] + ends[1]);
      }
      if (branch.low <= values[lowest]) break;
    }
  }
  for (TreeBranch& branch : tree.branches) {
    std::erase_if(branch.levels, [](const TreeLevel& level) { return !(level.length > 0); });
    for (TreeLevel& level : branch.levels) level.centre = (1 / level.length) * level.centre;
  }
}

}  // namespace

Result<TubeTree> growTree(const SurfaceMesh& mesh, std::span<const SurfacePoint> given,
                          const ExecutionContext& context) {
  auto ends = findEnds(mesh, given, context);
  if (!ends) return ends.error();
  TubeTree tree;
  std::vector<Index> count(mesh.componentCount(), 0);
  for (const TreeEnd& end : ends.value()) ++count[end.component];
  for (Index c = 0; c < count.size(); ++c) {
    if (count[c] > 1) continue;
    tree.others.push_back({c, mesh.genus(c) > 0 ? NoTube::Handle : NoTube::Blunt});
  }
  std::vector<spectral::FixedValue> fixed;
  std::vector<bool> isBegun(mesh.componentCount(), false);
  for (TreeEnd& end : ends.value()) {
    if (count[end.component] < 2) continue;
    for (const Vertex v : end.vertices) fixed.push_back({v, isBegun[end.component] ? 1.0 : 0.0});
    isBegun[end.component] = true;
    tree.ends.push_back(std::move(end));
  }
  const std::vector<double> values = spectral::harmonicFunction(mesh, fixed);
  if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
  if (values.empty()) {
    return makeError(ErrorCode::LimitExceeded, -1,
                     "the triangles are too irregular for centrelines: remesh the model");
  }
  BranchSearch search(mesh, tree.ends, values);
  search.run();
  std::tie(tree.branches, tree.branchOfVertex) = search.result();
  std::vector<std::vector<double>> valuesOf(tree.branches.size());
  for (const Vertex v : mesh.vertices()) {
    if (tree.branchOfVertex[v] != kNoIndex) valuesOf[tree.branchOfVertex[v]].push_back(values[v]);
  }
  for (std::size_t b = 0; b < tree.branches.size(); ++b) {
    tree.branches[b].levels = levelsOf(tree.branches[b], std::move(valuesOf[b]));
  }
  measureLevels(mesh, values, tree);
  return tree;
}

}  // namespace girth::tubes
