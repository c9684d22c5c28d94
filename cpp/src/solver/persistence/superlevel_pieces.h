// The superlevel set of the distance from p within one face: the points farther than a height. It
// is described by pieces of the rim of the face, and by which of them it connects
// (web/docs/definitions.md, Statement 2.10).
//
// The sublevel set is a union of sectors of disks: each holds the points that paths past one root
// reach within the height. A sector is convex and enters through the rim. So blocked arcs of the
// rim are connected as their sectors meet, and two pieces between them are connected unless blocked
// arcs separate them on both ways round the rim.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solver/search/pseudosources.h"

namespace girth {

/// A saddle nearer to a side, as a share of it, may lie on it.
inline constexpr double kSaddleOnSide = 1e-6;

/// A side of the loop of a saddle that lies inside a face or on its rim, in the frame of a halfedge
/// of the face.
struct SaddleSide {
  Index halfedge;
  geodesic::Vec2 point;                 ///< the saddle
  std::array<geodesic::Vec2, 2> roots;  ///< roots of the halves of its loop, straight behind it
  geodesic::Vec2 direction;             ///< at right angles to them, into this side
};

class SuperlevelPieces {
 public:
  /// Part of a side of the face that is farther than the height.
  struct Piece {
    Index halfedge;
    double begin, end;  ///< lengths along it
    std::size_t gap;    ///< number of the gap between two blocked arcs of the rim
  };

  /// Finds the pieces of a face. The propagation still keeps the face, and its frontier has passed
  /// the height there. `longest`: longer paths are ignored; it is the height, or the value that
  /// `isWithin` will be asked for. Time: O(k log k) for k paths into the face.
  void find(const geodesic::Propagation& propagation, Index face, double height, double longest);
  /// Finds the pieces of the part of a face on one side of a saddle's loop. `height` differs from
  /// that of the saddle by rounding only. False: the saddle lies on a side of the face that the
  /// loop crosses, or this side of the loop is in the face beyond.
  bool findBeside(const geodesic::Propagation& propagation, const SaddleSide& side, double height,
                  double longest);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The gap that the saddle lies in.
  std::size_t saddleGap() const { return arcs_.empty() ? 0 : arcs_.size() - 1; }
  /// Whether the superlevel set connects two gaps within what was found. The first call for a face
  /// takes the time of all pairs of paths.
  bool together(std::size_t gap, std::size_t other);
  /// Whether it connects two pieces; mostly the straight line between their middles shows it.
  bool together(const Piece& piece, const Piece& other) {
    return piece.gap == other.gap || isClear(piece, middleOf(other)) ||
           together(piece.gap, other.gap);
  }
  /// Whether no point of what was found is farther than `high`, which the frontier has passed.
  /// False: `above` is such a point, or is empty where the bounds are too coarse.
  bool isWithin(double high);
  /// A point that is farther, in the frame of the first halfedge of the face; of the last call of
  /// `isWithin`, if it was false for that.
  const std::optional<geodesic::Vec2>& above() const { return above_; }
  /// Whether every point on the straight way between this point and the middle of a piece is
  /// farther than the height.
  bool isClear(const Piece& piece, geodesic::Vec2 point) const;

  /// The number of paths that were examined since the last call.
  std::size_t takeWork();
  std::size_t memoryBytes() const;

 private:
  /// A side of what is looked at: part of a halfedge, or, where that is none, of the loop.
  struct Side {
    geodesic::Vec2 from, to;
    Index halfedge;
    double begin, end;  ///< lengths along the halfedge
    int half;           ///< half of the loop
  };
  /// Where the ends of a side lie as a pie sees them.
  struct Sight {
    double square;       ///< square of the distance from its root
    double left, right;  ///< within its bounds where these are positive
  };
  struct Pie {
    Pseudosource source;
    double reach;
    int half;         ///< half of the loop that it belongs to; -1: none
    std::size_t arc;  ///< arc of the rim
  };
  /// A blocked part of the rim: side number and share of the side, together.
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
  std::vector<Pseudosource> sources_;
  std::vector<Side> sides_;
  std::vector<Pie> pies_;
  std::vector<Blocked> blocked_, arcs_;
  std::vector<std::size_t> parent_;  // by arc, in the sets of those that hang together
  std::vector<Piece> pieces_;
  std::vector<geodesic::Vec2> polygon_, clipped_;
  std::vector<Triangle> cells_;
  std::optional<geodesic::Vec2> above_;
  std::size_t work_{0};
};

}  // namespace girth
