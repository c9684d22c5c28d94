// The rest of a face: what of it is farther from p than a height, as pieces of its rim that hang
// together within the face (web/docs/definitions.md, Statement 2.10).
//
// What is no farther is a union of pies: what the paths past one root reach within the height. Each
// is convex, and comes in through the rim. So the blocked arcs of the rim hang together as the pies
// that meet do, and two pieces between them hang together unless blocked arcs on both ways from the
// one to the other do.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "girth/sites.h"

namespace girth {

/// A side of the loop of a saddle that lies inside a face or on its rim, in the frame of a halfedge
/// of the face.
struct SaddleSide {
  Index halfedge;
  geodesic::Vec2 point;                 ///< the saddle
  std::array<geodesic::Vec2, 2> roots;  ///< of the halves of its loop, straight behind it
  geodesic::Vec2 direction;             ///< at right angles to them, into this side
};

class FaceRest {
 public:
  /// Part of a side of the face that is farther than the height.
  struct Piece {
    Index halfedge;
    double begin, end;  ///< lengths along it
    std::size_t gap;    ///< of the rim, between two blocked arcs
  };

  /// Finds the pieces of a face, which has not been forgotten and which the frontier has passed up
  /// to the height. `longest`: longer paths are not looked at, which may be the height, or what
  /// `isWithin` is to be asked for. Time: O(k log k) for k paths into the face.
  void find(const geodesic::Propagation& propagation, Index face, double height, double longest);
  /// The same of the part of a face on one side of a saddle's loop, which nothing crosses but
  /// there. `height` differs from that of the saddle by rounding. False: the saddle lies on a side
  /// of the face that the loop crosses, or this side of the loop is in the face beyond.
  bool findBeside(const geodesic::Propagation& propagation, const SaddleSide& side, double height,
                  double longest);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The gap that the saddle lies in.
  std::size_t saddleGap() const { return arcs_.empty() ? 0 : arcs_.size() - 1; }
  /// Whether two gaps hang together within what was looked at. The first call for a face takes the
  /// time of all pairs of paths.
  bool together(std::size_t gap, std::size_t other);
  /// Whether two pieces do; mostly as the straight way between their middles shows.
  bool together(const Piece& piece, const Piece& other) {
    return piece.gap == other.gap || isClear(piece, middleOf(other)) ||
           together(piece.gap, other.gap);
  }
  /// Whether no point of what was looked at is farther than this, which the frontier has passed.
  /// False: there is one, which `above` tells, or the bounds are not good enough.
  bool isWithin(double high);
  /// A point that is farther, in the frame of the first halfedge of the face; of the last call of
  /// `isWithin`, if it was false for that.
  const std::optional<geodesic::Vec2>& above() const { return above_; }
  /// Whether every point on the straight way between this point and the middle of a piece is
  /// farther than the height.
  bool isClear(const Piece& piece, geodesic::Vec2 point) const;

  /// Paths that were looked at since the last call of this.
  std::size_t takeWork();
  std::size_t memoryBytes() const;

 private:
  /// A side of what is looked at: part of a halfedge, or, where that is none, of the loop.
  struct Side {
    geodesic::Vec2 from, to;
    Index halfedge;
    double begin, end;  ///< lengths along the halfedge
    int half;           ///< of the loop
  };
  /// Where the ends of a side lie as a pie sees them.
  struct Sight {
    double square;       ///< of the distance from its root
    double left, right;  ///< within its bounds where these are positive
  };
  struct Pie {
    Site site;
    double reach;
    int half;         ///< of the loop, that it belongs to; -1: none
    std::size_t arc;  ///< of the rim
  };
  /// What is blocked of the rim: side number and share of the side, together.
  struct Blocked {
    double begin, end;
    std::size_t pie;
  };
  using Triangle = std::array<geodesic::Vec2, 3>;

  void gather(const geodesic::Propagation& propagation, Index face, double longest);
  bool cutAlong(const SaddleSide& side);
  void block(double height, const SaddleSide* side);
  Sight sightOf(const Pie& pie, geodesic::Vec2 point) const;
  static bool covers(const Pie& pie, geodesic::Vec2 from, geodesic::Vec2 to, const Sight& atFrom,
                     const Sight& atTo, double& begin, double& end);
  bool meet(const Pie& a, const Pie& b);
  geodesic::Vec2 middleOf(const Piece& piece) const;
  void findArcs();
  void joinArcs();
  void findPieces();
  std::size_t setOf(std::size_t arc) const;

  const geodesic::Propagation* propagation_{nullptr};
  double slack_{0};
  bool isCut_{false}, isJoined_{false};
  std::vector<Site> sites_;
  std::vector<Side> sides_;
  std::vector<Pie> pies_;
  std::vector<Blocked> blocked_, arcs_;
  std::vector<std::size_t> parent_;  // of the arcs, in the sets of those that hang together
  std::vector<Piece> pieces_;
  std::vector<geodesic::Vec2> polygon_, clipped_;
  std::vector<Triangle> cells_;
  std::optional<geodesic::Vec2> above_;
  std::size_t work_{0};
};

}  // namespace girth
