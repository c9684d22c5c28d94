#include "girth/persistent_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace girth {

using geodesic::kTie;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

void PersistentSearch::start(double persistence, std::size_t mostSaddles,
                             const std::atomic<bool>* cancel) {
  search_->start(cancel);
  cancel_ = cancel;
  persistence_ = persistence;
  mostSaddles_ = mostSaddles;
  saddles_.clear();
  ends_.clear();
  maxima_.clear();
  boundaries_.clear();
  atVertices_.clear();
  measured_ = 0;
  decided_ = work_ = 0;
  found_ = endedEarly_ = cancelled_ = gaveUp_ = false;
}

bool PersistentSearch::enough(double frontier) {
  while (search_->enough(frontier)) {
    if (search_->cancelled()) return true;
    add(search_->best());
  }
  if (search_->unjudged() * (1 + kTie) < frontier) return false;  // the budget is met
  for (; decided_ < saddles_.size(); ++decided_) {
    if (decided_ == mostSaddles_) return endedEarly_ = true;
    Saddle& saddle = saddles_[decided_];
    const double height = saddle.loop.length / 2, end = height + persistence_;
    const bool isFilled = saddle.death <= measured_;
    if (!isFilled && !(end <= measured_)) {
      const bool isComplete = std::isinf(frontier);
      if (!isComplete && !(end * (1 + kTie) < frontier)) return false;
      if (!measure(frontier)) return true;
    }
    if (saddle.death - height > persistence_) {
      ++decided_;
      return found_ = true;
    }
  }
  return false;
}

void PersistentSearch::add(const LoopCandidate& loop) {
  if (!divides(loop)) return;
  SaddleEnds ends{loop.length / 2, courses_.ofHalf(loop, loop.there, loop.back),
                  courses_.ofHalf(loop, loop.back, loop.there)};
  work_ += ends.there.size() + ends.back.size();
  // The same loop may be found in several faces, and past a flat vertex on either side.
  for (std::size_t i = ends_.size(); i-- > 0;) {
    const SaddleEnds& known = ends_[i];
    if (known.height < ends.height * (1 - 4 * kTogether)) break;
    if ((sameCourse(known.there, ends.there) && sameCourse(known.back, ends.back)) ||
        (sameCourse(known.there, ends.back) && sameCourse(known.back, ends.there))) {
      return;
    }
  }
  if (saddles_.empty()) {
    measured_ = ends.height * (1 - 4 * kTogether);
    propagation_->keepBeyond(measured_);
  }
  saddles_.push_back({loop, kNever});
  ends_.push_back(std::move(ends));
}

/// Whether both sides of a loop go on at its midpoint. Where a third path arrives there as well,
/// one side may be filled at once: a saddle and a maximum in one, which has no persistence. At a
/// vertex with several gaps, of the loops that divide them alike one counts.
bool PersistentSearch::divides(const LoopCandidate& loop) {
  findArrivals(*propagation_, loop.halfedge, loop.midpoint, loop.length / 2 * (1 + kTogether),
               arrivals_);
  work_ += arrivals_.paths.size();
  arrivals_.surround(kFullGap);  // sorts
  const std::vector<PathArrival>& paths = arrivals_.paths;
  if (paths.empty()) return false;
  const Index vertex = arrivals_.vertex;
  const bool mayPart = vertex != kNoIndex && courses_.bends(vertex);
  if (mayPart && loop.there.vertex != vertex && loop.back.vertex != vertex) return false;
  const bool isStored = loop.there.vertex == vertex;
  double from = directionOf(loop, isStored ? loop.there : loop.back);
  double to = directionOf(loop, isStored ? loop.back : loop.there);
  const bool isSwapped = from > to;
  if (isSwapped) std::swap(from, to);

  // The gaps between the two, and the others.
  constexpr double kSame = 1e-6;
  std::size_t between = 0, around = 0;
  for (std::size_t i = 0; i + 1 < paths.size(); ++i) {
    const double a = paths[i].direction, b = paths[i + 1].direction;
    if (b - a < kFullGap) continue;
    if (a >= from - kSame && b <= to + kSame) {
      ++between;
    } else {
      ++around;
    }
  }
  if (arrivals_.open ||
      paths.front().direction + arrivals_.total - paths.back().direction >= kFullGap) {
    ++around;
  }
  if (between == 0 || around == 0) return false;
  if (!mayPart) return true;
  const AtVertex here{vertex, isSwapped ? around : between};
  for (const AtVertex& known : atVertices_) {
    if (known.vertex == here.vertex && known.gaps == here.gaps) return false;
  }
  atVertices_.push_back(here);
  return true;
}

/// The direction at the midpoint of a loop in which one of its halves arrives.
double PersistentSearch::directionOf(const LoopCandidate& loop, const PathHalf& half) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index vertex = arrivals_.vertex;
  if (vertex != kNoIndex) {
    if (half.vertex == vertex) return propagation_->arrivalDirection(vertex);
    if (half.bundle.halfedge != kNoIndex) {
      // As a point of its face, a vertex is the corner at which the direction is taken.
      const Index face = faceOfSide(half.bundle.halfedge);
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (unfolding.crossing(h).from() != vertex) continue;
        return unfolding.directionOf(h,
                                     unfolding.toFrame(half.bundle.halfedge, h, half.bundle.root));
      }
    }
    if (half.vertex != kNoIndex) return courses_.directionOfEdge(vertex, half.vertex);
  }
  Vec2 from{};
  if (half.bundle.halfedge != kNoIndex) {
    from = unfolding.toFrame(half.bundle.halfedge, loop.halfedge, half.bundle.root);
  } else if (half.vertex != kNoIndex) {
    const Index face = faceOfSide(loop.halfedge);
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (unfolding.crossing(h).from() == half.vertex) {
        from = unfolding.toFrame(h, loop.halfedge, {0, 0});
      }
    }
  } else {
    for (const geodesic::Propagation::Origin& origin : propagation_->origins()) {
      if (origin.face == faceOfSide(loop.halfedge)) {
        from = unfolding.toFrame(3 * origin.face, loop.halfedge, origin.place);
      }
    }
  }
  return arrivals_.directionTo(unfolding, loop.halfedge, loop.midpoint, from);
}

/// Finds what has been filled below the frontier. False: cancelled, or given up.
bool PersistentSearch::measure(double frontier) {
  const std::size_t done = propagation_->windowsCrossed() + effort();
  const std::size_t left = propagation_->budget() - std::min(done, propagation_->budget());
  const bool isComplete = std::isinf(frontier);
  const double high = isComplete ? frontier : frontier * (1 - kTie);
  const bool known = maximaSearch_.find(measured_, high, 2 * left, cancel_, maxima_);
  work_ += maximaSearch_.work();
  if (!known) {
    cancelled_ = cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
    gaveUp_ = !cancelled_;
    return false;
  }
  measured_ = high;
  propagation_->keepBeyond(high * (1 - 4 * kTogether));
  if (isComplete) findBoundaries();
  const std::vector<double> deaths = saddleDeaths(ends_, maxima_, boundaries_, isComplete);
  for (std::size_t i = decided_; i < saddles_.size(); ++i) {
    const double height = ends_[i].height;
    saddles_[i].death = deaths[i] > height * (1 + 4 * kTogether) ? deaths[i] : height;
  }
  return true;
}

/// The paths to all boundary curves of the component.
void PersistentSearch::findBoundaries() {
  const Unfolding& unfolding = propagation_->unfolding();
  std::vector<bool> visited;
  for (const Index v : propagation_->reachedVertices()) {
    if (!unfolding.boundary(v)) continue;
    if (visited.empty()) visited.resize(unfolding.vertexCount(), false);
    if (visited[v]) continue;
    boundaries_.push_back(courses_.beyondBoundary(v));
    // Round the curve: at a boundary vertex the first halfedge lies on the boundary.
    for (Index at = v; !visited[at];) {
      visited[at] = true;
      at = unfolding.crossing(unfolding.outgoing(at)).to();
    }
  }
}

std::size_t PersistentSearch::memoryBytes() const {
  std::size_t bends = 0;
  for (const SaddleEnds& ends : ends_) bends += ends.there.capacity() + ends.back.capacity();
  for (const LocalMaximum& maximum : maxima_) bends += maximum.course.capacity();
  return maximaSearch_.memoryBytes() + saddles_.capacity() * sizeof(Saddle) +
         ends_.capacity() * sizeof(SaddleEnds) + maxima_.capacity() * sizeof(LocalMaximum) +
         bends * sizeof(Bend);
}

}  // namespace girth
