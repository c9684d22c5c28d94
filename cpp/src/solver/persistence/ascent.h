// The two sides of a saddle of the distance from p: a proof, without the maximum, that a side rises
// above a certain height, or that it does not (web/docs/definitions.md, Statements 2.9 to 2.11).
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geodesic/propagation.h"
#include "solver/persistence/superlevel_pieces.h"

namespace girth {

/// Walks through the superlevel set on one side of a saddle, from face to face.
class Ascent {
 public:
  explicit Ascent(const geodesic::Propagation& propagation) : propagation_(&propagation) {}

  /// Whether a way is found from a saddle at the distance `low` on one side of its loop, along
  /// which every point is farther, and which leads to a boundary curve or to a point farther than
  /// `high`. The frontier tells which points are farther, once it has passed `high`; before, the
  /// distance in space tells it, and an area around in which nothing has been reached. The frontier
  /// has passed `low`. False: none was found, though there may be one. Distances are in the unit of
  /// the unfolding. Time: at most a quarter of a million paths are looked at.
  bool leads(const SaddleSide& side, double low, double high);

  /// Whether the walk sees all of the superlevel set on one side of a saddle and no point of it is
  /// farther than `high`, which the frontier has passed. False: not proven.
  bool isFilled(const SaddleSide& side, double low, double high);

  /// Paths that the last call looked at.
  std::size_t work() const { return work_; }
  std::size_t memoryBytes() const;

 private:
  /// A piece of an edge that a way has reached in the face of a halfedge.
  struct Place {
    Index halfedge;
    double begin, end;  ///< lengths along it
    double middle() const { return (begin + end) / 2; }
  };

  void start(double low, double high);
  SaddleSide beyond(const SaddleSide& side, Index halfedge) const;
  void goStraight(const SaddleSide& side);
  bool isClear(Index halfedge, geodesic::Vec2 from, geodesic::Vec2 to, bool isFirst);
  void setOut(const SaddleSide& side);
  void goOn(const Place& place);
  bool isKnown(const SuperlevelPieces::Piece& piece) const;
  void reach(const SuperlevelPieces::Piece& piece);
  bool rises(const SuperlevelPieces::Piece& from);
  void enter(const Place& place);
  bool isEntered(std::size_t gap);
  void addEntered();
  bool isFarther(Index halfedge, double at);
  bool isFarFromAll(Index halfedge, Vec3 point);
  double fromReached(Vec3 point) const;
  bool isUnreached(Index face) const;
  bool isKnown(const std::vector<Place>& places, Index halfedge, double begin, double end) const;
  Vec3 positionOn(Index halfedge, double at) const;
  Vec3 cornerOf(Index vertex) const;

  const geodesic::Propagation* propagation_;
  double low_{0}, high_{0};
  Vec3 origin_;         // p
  double straight_{0};  // whatever is farther than this in space is farther than `high`
  double radius_{0};    // whatever is so far from all that has been reached is farther, too
  bool isPassed_{false}, found_{false};
  std::size_t work_{0};
  SuperlevelPieces rest_, upper_;
  std::vector<Place> places_, seen_;
  std::vector<std::size_t> gaps_;
  std::vector<std::pair<double, std::size_t>>
      heap_;  // places: first those far from all that is known to have been reached
  std::vector<Vec3> reached_;        // points within the height, in space
  std::vector<Index> around_;        // faces
  std::vector<std::uint32_t> turn_;  // in which a face was looked at
  std::uint32_t turns_{0};
};

}  // namespace girth
