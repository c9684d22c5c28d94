// The saddles of the distance from p that last, while the disk grows: the loop search goes on from
// each saddle until it is known whether a side of its loop is filled in time
// (web/docs/definitions.md, section 2).
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "solver/persistence/ascent.h"
#include "solver/persistence/saddle_tree.h"
#include "solver/search/local_maxima.h"
#include "solver/search/loop_search.h"

namespace girth {

/// A visitor of Propagation::run that ends with the first saddle of more than a certain
/// persistence.
class PersistentSearch {
 public:
  /// The propagation that it will visit; `search` is the search of that propagation.
  PersistentSearch(geodesic::Propagation& propagation, LoopSearch& search)
      : propagation_(&propagation),
        search_(&search),
        maximaSearch_(propagation),
        pathOrder_(propagation),
        ascent_(propagation) {}

  /// `persistence`: in the unit of the unfolding. `mostSaddles`: the search ends when so many have
  /// been decided. `withDeaths`: of those that do not last it is to be known when they die.
  /// `reach`: in the unit of the unfolding; the search ends when all saddles up to there have been
  /// met.
  void start(double persistence, std::size_t mostSaddles, bool withDeaths, double reach,
             const std::atomic<bool>* cancel);

  bool enough(double frontier);
  bool interrupted() { return search_->interrupted(); }
  void restart() { start(persistence_, mostSaddles_, withDeaths_, reach_, cancel_); }
  void onCrossing(Index halfedge, std::uint32_t first, const geodesic::CrossingResult& result) {
    search_->onCrossing(halfedge, first, result);
  }
  void onVertex(Index vertex) { search_->onVertex(vertex); }
  std::size_t effort() const { return search_->effort() + work_ / 2; }

  /// A saddle of the distance from p.
  struct Saddle {
    LoopCandidate loop;
    /// When a side of the loop was filled: only of those that are decided, and if deaths were asked
    /// for; infinite: not up to the persistence that was asked for, or never.
    double death;
    /// Its midpoint lies inside a face, or on an edge, and no third path arrives there.
    bool isPlain;
    Index vertex;  ///< the vertex that the midpoint is; kNoIndex: none
    /// Rounding may have filled a side at once: a maximum as high as the saddle lies on it, or a
    /// third path arrives at the midpoint. It is not filled where it has a higher maximum, which is
    /// known once all maxima are.
    bool isOpenToRounding{false};
  };
  /// The saddles that were met, in the order of their heights.
  const std::vector<Saddle>& saddles() const { return saddles_; }
  /// The maxima that were looked for, in no order.
  const std::vector<LocalMaximum>& maxima() const { return maxima_; }
  /// So many of the saddles, the first ones, have been decided: it is known whether they last.
  std::size_t decided() const { return decided_; }
  /// Whether the last one decided lasts.
  bool found() const { return found_; }
  /// Whether there are more saddles than were to be decided.
  bool endedEarly() const { return endedEarly_; }
  bool cancelled() const { return search_->cancelled() || cancelled_; }
  /// Whether the budget did not suffice to look for the maxima.
  bool gaveUp() const { return gaveUp_; }
  std::size_t memoryBytes() const;

 private:
  void add(const LoopCandidate& loop);
  void addAtVertex(const LoopCandidate& loop);
  void addAtVertex(const LoopCandidate& loop, double stored, double other);
  void push(const Saddle& saddle);
  bool isKnown(const Saddle& saddle) const;
  /// Numbers of gaps between arrivals in which the frontier goes on.
  struct Gaps {
    std::size_t between{0}, around{0};
  };
  Gaps gapsBeside(double from, double to) const;
  bool areOne(const SaddleEnds& a, const SaddleEnds& b) const;
  bool isLower(const LocalMaximum& maximum, const SaddleEnds& saddle) const;
  bool runAlike(const SaddleEnds& a, const SaddleEnds& b) const;
  bool liesBetween(const LocalMaximum& maximum, const SaddleEnds& a, const SaddleEnds& b) const;
  bool divides(const LoopCandidate& loop);
  void leaveOutApart(const LoopCandidate& loop);
  double directionOf(const LoopCandidate& loop, const PathHalf& half) const;
  geodesic::Vec2 rootOf(const LoopCandidate& loop, const PathHalf& half) const;
  enum class Fate : std::uint8_t { Lasts, Dies, Unknown };
  Fate foresee(const Saddle& saddle, double end, bool isPassed);
  bool isBesideCorner(const Saddle& saddle) const;
  bool isAlone(const Saddle& saddle) const;
  void findEnds();
  bool measure(double frontier);
  void findBoundaries();

  geodesic::Propagation* propagation_;
  LoopSearch* search_;
  MaximaSearch maximaSearch_;
  PathOrder pathOrder_;
  Ascent ascent_;
  const std::atomic<bool>* cancel_{nullptr};
  double persistence_{0}, reach_{0};
  std::size_t mostSaddles_{0};
  std::vector<Saddle> saddles_;
  std::vector<SaddleEnds> ends_;  // ends of the first saddles, as far as they were asked for
  /// Saddles at vertices, with the gaps on one side of their loops: there may be several.
  struct AtVertex {
    Index vertex;
    std::size_t gaps;
  };
  std::vector<AtVertex> atVertices_;
  std::vector<LocalMaximum> maxima_;
  std::vector<BentPath> boundaries_;
  Arrivals arrivals_;
  double measured_{0};  // everything is known up to here
  std::size_t decided_{0}, work_{0};
  int attempts_{0};              // to foresee what becomes of the next one
  std::array<bool, 2> leads_{};  // its sides that were seen to
  bool withDeaths_{false};
  bool found_{false}, endedEarly_{false}, cancelled_{false}, gaveUp_{false};
};

}  // namespace girth
