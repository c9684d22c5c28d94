// The local maxima of the distance from p: the points at which the frontier vanishes. There it
// fills the regions that loops have cut off (web/docs/definitions.md, section 2).
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "solver/persistence/path_order.h"
#include "solver/search/pseudosources.h"

namespace girth {

/// A point at which the frontier vanishes.
struct LocalMaximum {
  double distance;
  /// A path that arrives there on the far side from the widest gap between paths.
  BentPath path;
};

/// Finds them exactly: at vertices, and where at least three paths arrive together inside a face or
/// on its rim, from directions that leave no gap of π. A face is parted until few paths compete in
/// each part, or until all of them come from one side. Points of the boundary do not count.
class MaximaSearch {
 public:
  explicit MaximaSearch(const geodesic::Propagation& propagation);

  /// Adds those at distances from `low` on, up to `high`. The frontier has passed `high`, and no
  /// face with a point beyond `low` has been forgotten. One that lies on the side of two faces may
  /// be found twice. False: more than `mostWork` paths into faces were looked at, or the work was
  /// cancelled.
  bool find(double low, double high, std::size_t mostWork, const std::atomic<bool>* cancel,
            std::vector<LocalMaximum>& maxima);

  /// Paths into faces that the last call looked at.
  std::size_t work() const { return work_; }
  std::size_t memoryBytes() const;

 private:
  /// Triples of so few sources are all tried in a whole face; in its parts more of them, since
  /// along some curve of the face any number of sources may tie.
  static constexpr std::size_t kFewSources = 4;

  /// A triangle of a face, in the frame of its first halfedge, with the sources that may be nearest
  /// to a point of it.
  struct Cell {
    std::array<geodesic::Vec2, 3> corners;
    std::vector<Pseudosource> sources;
    std::size_t halvings{0};  ///< halvings of the face
  };

  void tryVertex(Index vertex);
  bool sendsInto(Index out) const;
  bool allFromOneSide(Index face);
  bool tryFace(Index face, std::size_t mostWork);
  void tryCell(Cell cell);
  void tryTriples(const std::vector<Pseudosource>& roots, const Cell& cell, geodesic::Vec2 centre,
                  double radius);
  void tryPoint(geodesic::Vec2 point, double distance);
  void add(double distance, Index vertex, Index halfedge, geodesic::Vec2 point);

  const geodesic::Propagation* propagation_;
  PathOrder pathOrder_;
  double longestSide_{0};
  double low_{0}, high_{0};
  std::vector<LocalMaximum>* maxima_{nullptr};
  Index face_{0};
  std::vector<Pseudosource> sources_, roots_;
  std::vector<Pseudosource> bounds_;  // corners that send no paths into the face
  std::vector<Cell> cells_;
  std::vector<geodesic::Vec2> tried_;  // points of the face
  Arrivals arrivals_;
  std::size_t work_{0};
};

}  // namespace girth
