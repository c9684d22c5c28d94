// The search for the shortest loop while the geodesic disk grows: Algorithm 2 of the paper,
// section 4.4.
//
// Read literally, Lemmas 4.1 and 4.2 go wrong at one vertex in ten: the windows they pair may have
// been dropped just past the midpoint q, and windows that survive may form a straight line whose
// halves are not shortest. The search used instead, and why no loop is lost:
// - Let q be the point of the true loop farthest from p, f a face that contains q, and the segment
//   through q the part of the loop inside f. Both halves are shortest paths, so where each enters f
//   it is the one shortest path, and its window exists and enters f before the frontier reaches q.
//   So we pair windows that enter the same face through different sides, and ask that q lies in
//   that face (paper, case 3); a window with the path that ends at the opposite corner (case 2), or
//   with p itself where p lies inside the face; and the paths to the two ends of an edge (case 1).
//   A loop whose q is a vertex is the limit of case 2. Whichever of the two comes later makes the
//   pair.
// - A pair is only a candidate. When the frontier has passed half its length, the exact distance of
//   q is known; the candidate stands if that is half its length, and otherwise it is no loop at
//   all. A face that has been forgotten was passed before, so q was nearer.
// - Lines through windows and bends at vertices are exact to kAim and kStraight, so that whether a
//   third path to q is shorter than the halves can be decided to kShortest.
// - Where the paths that arrive at q leave no gap of π, the frontier does not touch itself there,
//   but vanishes: a farthest point, at least locally, and no loop (paper, figure 1b).
// - Candidates are judged in the order of their lengths, so the first that stands is the shortest.
#pragma once

#include <array>
#include <atomic>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "geodesic/propagation.h"
#include "girth/girth_solver.h"
#include "solver/search/arrivals.h"

namespace girth {

/// A straight connection of two paths from p, as yet unproven.
struct LoopCandidate {
  double length{0};
  /// The ends of its halves, in the face of q.
  PathHalf there, back;
  /// q, in the frame of a halfedge of a face that contains it.
  Index halfedge{0};
  geodesic::Vec2 midpoint;
};

/// A visitor of Propagation::run; `found` is its answer.
class LoopSearch {
 public:
  explicit LoopSearch(const geodesic::Propagation& propagation) : propagation_(&propagation) {}

  void start(const std::atomic<bool>* cancel);

  /// Whether there is a loop. Asked again, whether there is another one: each time the shortest of
  /// those that are left, no longer than twice the frontier.
  bool enough(double frontier);
  /// Whether the work has been cancelled.
  bool interrupted();
  void restart() { start(cancel_); }
  void onCrossing(Index halfedge, std::uint32_t first, const geodesic::CrossingResult& result);
  void onVertex(Index vertex);

  bool found() const { return found_; }
  bool cancelled() const { return cancelled_; }
  /// No loop that has not been judged is shorter than twice this; infinite: none is left.
  double unjudged() const {
    return candidates_.empty() ? std::numeric_limits<double>::infinity()
                               : candidates_.front().length / 2;
  }
  /// The pairs of windows tried, as a number of windows that could have crossed a face meanwhile.
  std::size_t effort() const { return pairs_ / kPairsPerWindow; }
  /// The loop that was found last; after a run that ended with the first, the shortest.
  const LoopCandidate& best() const { return best_; }
  std::size_t memoryBytes() const {
    return (candidates_.capacity() + judged_.capacity()) * sizeof(LoopCandidate) +
           std::accumulate(gathered_.begin(), gathered_.end(), std::size_t{0},
                           [](std::size_t bytes, const Gathered& gathered) {
                             return bytes + gathered.windows.capacity() * sizeof(geodesic::Window);
                           });
  }

 private:
  static constexpr std::size_t kPairsPerWindow = 16;

  /// The windows that have entered through a halfedge, one behind the other.
  struct Gathered {
    Index halfedge{kNoIndex};
    std::vector<geodesic::Window> windows;
  };

  const std::vector<geodesic::Window>& windowsOf(Index halfedge);
  void pairAcross(Index halfedge, std::uint32_t first, Index other);
  void pair(Index halfedge, const geodesic::Window& a, Index other, const geodesic::Window& b);
  std::optional<LoopCandidate> pairWithPoint(Index halfedge, const geodesic::Window& window,
                                             geodesic::Vec2 point, double atPoint,
                                             Index vertex) const;
  void tryApex(Index halfedge, const geodesic::Window& window);
  void tryOrigin(Index halfedge, const geodesic::Window& window,
                 const geodesic::Propagation::Origin& origin);
  void tryEdgesOnwards(Index vertex);
  void tryEdge(Index halfedge);
  bool worthwhile(double length, Index halfedge, geodesic::Vec2 midpoint) const;
  void propose(const LoopCandidate& candidate);
  bool isJudged(const LoopCandidate& candidate) const;
  bool proven(const LoopCandidate& candidate);
  bool closesUpon(const LoopCandidate& candidate);

  const geodesic::Propagation* propagation_;
  const std::atomic<bool>* cancel_{nullptr};
  std::vector<LoopCandidate> candidates_;  // a heap, shortest on top
  std::array<Gathered, 16> gathered_;      // windows that the new ones are paired with
  std::vector<LoopCandidate> judged_;      // the last of which closesUpon was asked
  Arrivals arrivals_;                      // at a midpoint
  geodesic::WindowNumber nearer_;          // the window that disproved the last candidate
  LoopCandidate best_;
  std::size_t pairs_{0};  // pairs of windows that were tried
  bool found_{false}, cancelled_{false};
};

}  // namespace girth
