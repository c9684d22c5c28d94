// The points at which the frontier vanishes: the local maxima of the distance from p, where the
// parts of the rest that loops have cut off are filled (web/docs/definitions.md, section 2).
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "girth/course.h"
#include "girth/sites.h"

namespace girth {

/// A point at which the frontier vanishes.
struct LocalMaximum {
  double distance;
  /// Of a path that arrives there on the far side from the widest gap between them.
  Course course;
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
  /// Triples of so few sites are all tried.
  static constexpr std::size_t kFewSites = 4;

  /// A triangle of a face, in the frame of its first halfedge, with the sites that may be nearest
  /// to a point of it.
  struct Cell {
    std::array<geodesic::Vec2, 3> corners;
    std::vector<Site> sites;
  };

  void tryVertex(Index vertex);
  bool sendsInto(Index out) const;
  bool allFromOneSide(Index face);
  void tryFace(Index face);
  void tryCell(Cell cell);
  void tryTriples(const std::vector<Site>& roots, const Cell& cell, geodesic::Vec2 centre,
                  double radius);
  void tryPoint(geodesic::Vec2 point, double distance);
  void add(double distance, Index vertex, Index halfedge, geodesic::Vec2 point);

  const geodesic::Propagation* propagation_;
  Courses courses_;
  double longestSide_{0};
  double low_{0}, high_{0};
  std::vector<LocalMaximum>* maxima_{nullptr};
  Index face_{0};
  std::vector<Site> sites_, roots_;
  std::vector<Site> bounds_;  // corners that send no paths into the face
  std::vector<Cell> cells_;
  std::vector<geodesic::Vec2> tried_;  // points of the face
  Arrivals arrivals_;
  std::size_t work_{0};
};

}  // namespace girth
