// The search for the shortest loop while the geodesic disk grows: Algorithm 2 of the paper,
// section 4.4.
//
// Read literally, Lemmas 4.1 and 4.2 go wrong at one vertex in ten: the windows they pair may have
// been dropped just past the midpoint q, and windows that survive may form a straight line whose
// halves are not shortest. What is done instead, and why no loop is lost:
// - Let q be the point of the true loop farthest from p, f a face that contains q, and the segment
// through q
//   the part of the loop inside f. Both halves are shortest paths, so where each enters f it is the
//   one shortest path, and its window exists and enters f before the frontier reaches q. So we pair
//   windows that enter the same face through different sides, and ask that q lies in that face
//   (paper, case 3); a window with the path that ends at the opposite corner (case 2); and the
//   paths to the two ends of an edge (case 1). A loop whose q is a vertex is the limit of case 2.
//   Whichever of the two comes later makes the pair.
// - A pair is only a candidate. When the frontier has passed half its length, the exact distance of
// q is
//   known; the candidate is the answer if that is half its length, and otherwise no loop at all.
// - Candidates are judged in the order of their lengths, so the first that stands is the shortest.
#pragma once

#include <atomic>
#include <vector>

#include "geodesic/propagation.h"
#include "girth/girth_solver.h"

namespace girth {

/// A straight connection of two paths from p, as yet unproven.
struct LoopCandidate {
  /// What the two halves end with.
  enum class Ends : std::uint8_t {
    WindowWindow,  ///< windows `first` and `second` of one face
    WindowVertex,  ///< window `first`, and the path to the corner opposite its halfedge
    VertexVertex,  ///< the paths to both ends of halfedge `first`
  };
  double length{0};
  Ends ends{Ends::WindowWindow};
  Index first{kNoIndex}, second{kNoIndex};
  /// q, in the frame of a face that contains it.
  Index face{0};
  geodesic::Vec2 midpoint;
};

/// A visitor of Propagation::run; afterwards `found` tells.
class LoopSearch {
 public:
  explicit LoopSearch(const geodesic::Propagation& propagation) : propagation_(&propagation) {}

  void start(const std::atomic<bool>* cancel);

  bool enough(double frontier);
  void onWindow(Index window, double tip);
  void onVertex(Index vertex);

  bool found() const { return found_; }
  bool cancelled() const { return cancelled_; }
  /// The shortest loop; only where found.
  const LoopCandidate& best() const { return best_; }
  /// Whether the frontier closes at the midpoint from all sides at once (paper, figure 1b): the
  /// paths that arrive there leave no gap of π in which it could go on.
  bool closesUpon(const LoopCandidate& candidate) const;

 private:
  void pair(Index window, Index other);
  void tryTip(Index window, double tip);
  void tryEdge(Index halfedge);
  void propose(const LoopCandidate& candidate);
  bool proven(const LoopCandidate& candidate) const;

  const geodesic::Propagation* propagation_;
  const std::atomic<bool>* cancel_{nullptr};
  std::vector<LoopCandidate> candidates_;  // a heap, shortest on top
  LoopCandidate best_;
  bool found_{false}, cancelled_{false};
};

}  // namespace girth
