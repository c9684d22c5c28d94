// Ways over the surface on which the girth rises least.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::loops {

/// The girth on a triangulation of the surface that is made finer where ways turn out to depend on
/// it. Keeps what it has refined from one search to the next.
class PassSearch {
 public:
  /// The girth at points.
  using Girth = std::function<Result<std::vector<double>>(std::span<const SurfacePoint> points)>;

  /// `girth`: of the vertices; where it is NaN no way leads. With both negated, ways fall least.
  /// O(n).
  PassSearch(const SurfaceMesh& mesh, std::span<const double> girth, Girth girthAt);

  /// The least height of ways from some vertices to others: the greatest girth on a way, at least
  /// `level`; infinite where there is none. Edges are halved until they are shorter than `finest`,
  /// in model units, where it matters (girth/necks.h). `isEnd`: for each vertex. Errors: those of
  /// the girth.
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
  struct Way {
    double height;
    std::vector<Index> nodes;
  };

  static std::uint64_t segment(Index a, Index b);
  /// Weights, in a cell's face, of a point between two of its nodes, at a share of the way.
  static std::array<double, 3> weightsBetween(const Cell& cell, Index a, Index b, double share);
  double length(Index a, Index b) const;
  Way lowestWay(std::span<const Index> starts, const std::vector<bool>& isEnd, double level);
  /// The same, with what it depends on made finer.
  Result<Way> refinedWay(std::span<const Index> starts, const std::vector<bool>& isEnd,
                         double level, double finest);
  /// The segments longer than `step` between whose ends the girth may rise beyond a way's height by
  /// more than that, and those round the way's highest points, which may have a lower one beside
  /// them.
  std::vector<std::pair<Index, Index>> coarseOn(const Way& way, double step) const;
  void addCell(const Cell& cell);
  void removeCell(Index cell);
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
  // Of the last search.
  std::vector<double> reached_;
  std::vector<Index> before_, touched_;
};

}  // namespace girth::loops
