// Ways over the surface on which the girth rises least.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "loops/necks/minimax_paths.h"

namespace girth::loops {

/// The girth on a triangulation of the surface that is made finer where ways turn out to depend on
/// it. Keeps what it has refined from one search to the next.
class PassSearch {
 public:
  PassSearch(const PassSearch&) = delete;
  PassSearch& operator=(const PassSearch&) = delete;

  /// The girth at points.
  using Girth = std::function<Result<std::vector<double>>(std::span<const SurfacePoint> points)>;

  /// A straight piece within a face, from the place of a node.
  struct Segment {
    Index node;
    SurfacePoint from, to;
    Face face;
  };
  /// For each segment a length such that the girth is on none of its points more than this and than
  /// at both ends; infinite where none is known.
  using UpperBound = std::function<Result<std::vector<double>>(std::span<const Segment> segments)>;

  /// `girth`: of the vertices; where it is NaN no way leads. With both negated, ways fall least.
  /// `upperBoundOf`: where given, pieces of which it shows that they matter no more are not halved.
  /// O(n).
  PassSearch(const SurfaceMesh& mesh, std::span<const double> girth, Girth girthAt,
             UpperBound upperBoundOf = {});

  /// The least height of ways from some vertices to others: the greatest girth on a way, at least
  /// `level`; infinite where there is none. Edges are halved until they are shorter than `finest`,
  /// in model units, or than a hundredth of what the height is above the level, where it matters
  /// (girth/necks.h). `isEnd`: for each vertex. Errors: those of the girth and the bound.
  Result<double> height(std::span<const Vertex> starts, const std::vector<bool>& isEnd,
                        double level, double finest);

  /// Makes a point of the surface one that ways can begin and end at; returns its number. O(n).
  Index insert(const SurfacePoint& point, double value);

  /// A way over the surface.
  struct Path {
    double height;                     ///< the greatest value on it, but at least that of its ends
    std::vector<SurfacePoint> points;  ///< empty where there is none; the height is infinite then
    std::vector<double> values;        ///< at them
  };
  /// The lowest way between two inserted points, as `height` finds it.
  Result<Path> between(Index from, Index to, double finest);

 private:
  struct Cell {
    Index face;
    std::array<Index, 3> nodes;
    std::array<std::array<double, 3>, 3> weights;
  };
  using NodePath = MinimaxPaths::Path;

  static std::uint64_t segment(Index a, Index b);
  /// Weights, in a cell's face, of a point between two of its nodes, at a share of the way.
  static std::array<double, 3> weightsBetween(const Cell& cell, Index a, Index b, double share);
  double length(Index a, Index b) const;
  /// The lowest way, with what it depends on made finer, down to `finest` or to a share of what it
  /// rises above the level.
  Result<NodePath> refinedWay(std::span<const Index> starts, const std::vector<bool>& isEnd,
                              double level, double finest, double share);
  /// The segments longer than `step` between whose ends the girth may rise beyond a way's height by
  /// more than that, and those round the way's highest points, which may have a lower one beside
  /// them.
  Result<std::vector<std::pair<Index, Index>>> coarseOn(const NodePath& way, double step);
  /// Takes out the segments of which upper bounds show that the girth is nowhere more than a
  /// height.
  std::optional<Error> dropBelow(double height, std::vector<std::pair<Index, Index>>& segments);
  /// The longest side of the cells beside a segment, then of the cells beside that, and so on to a
  /// side that is the longest of all cells beside it. Halving these makes no cell narrower than
  /// half the narrowest angle there is, and so it ends.
  std::pair<Index, Index> longestFrom(Index a, Index b) const;
  void addCell(const Cell& cell);
  void removeCell(Index cell);
  /// One of the cells beside the segment between two nodes.
  Index cellBeside(Index a, Index b) const;
  /// The middle of the segment between two nodes.
  SurfacePoint middleOf(Index a, Index b) const;
  /// Divides the segment between two nodes at a share of the way, and the cells on both sides of
  /// it.
  void divide(Index a, Index b, double share, double value);
  /// A node at a place, without segments.
  Index addNode(const SurfacePoint& point, const Vec3& place, double value);

  const SurfaceMesh& mesh_;
  std::vector<Vec3> places_;
  std::vector<SurfacePoint> points_;
  std::vector<double> values_;
  std::vector<std::vector<Index>> neighbours_;
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, std::array<Index, 2>> cellsAt_;
  double coarsest_;
  Girth girthAt_;
  UpperBound upperBoundOf_;
  /// Upper bounds of segments, by the node that they are seen from and the other one.
  std::unordered_map<std::uint64_t, double> upperBounds_;
  MinimaxPaths ways_{values_, neighbours_};
};

}  // namespace girth::loops
