#include "solver/persistence/persistent_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "infinity.h"

namespace girth {

using geodesic::kTie;
using geodesic::Unfolding;
using geodesic::Vec2;

void PersistentSearch::start(double persistence, std::size_t mostSaddles, bool withDeaths,
                             double reach, const std::atomic<bool>* cancel) {
  search_->start(cancel);
  cancel_ = cancel;
  persistence_ = persistence;
  mostSaddles_ = mostSaddles;
  withDeaths_ = withDeaths;
  reach_ = reach;
  saddles_.clear();
  ends_.clear();
  maxima_.clear();
  boundaries_.clear();
  atVertices_.clear();
  measured_ = 0;
  decided_ = work_ = 0;
  attempts_ = 0;
  leads_ = {};
  found_ = endedEarly_ = cancelled_ = gaveUp_ = false;
}

bool PersistentSearch::enough(double frontier) {
  // By then all paths are known that arrive at a midpoint together with the halves of its loop.
  const double passed = frontier * (1 - 4 * kTogether);
  while (search_->enough(passed)) {
    if (search_->cancelled()) return true;
    add(search_->best());
  }
  if (reach_ * (1 + kTie) < passed) return endedEarly_ = true;
  if (search_->unjudged() * (1 + kTie) < passed) return false;  // the budget is met
  for (; decided_ < saddles_.size(); ++decided_, attempts_ = 0, leads_ = {}) {
    if (decided_ == mostSaddles_) return endedEarly_ = true;
    Saddle& saddle = saddles_[decided_];
    const double height = saddle.loop.length / 2, end = height + persistence_;
    const bool isComplete = std::isinf(frontier);
    if (saddle.isOpenToRounding && !isComplete) return false;
    const bool isFilled = saddle.death <= measured_;
    if (saddle.isOpenToRounding || (!isFilled && !(end <= measured_))) {
      const bool isPassed = isComplete || end * (1 + kTie) < frontier;
      // Where its sides are seen, no maximum needs to be known. Nothing lasts longer than for ever.
      if (std::isfinite(end) && (attempts_ == 0 || (attempts_ == 1 && isPassed))) {
        attempts_ = isPassed ? 2 : 1;
        const Fate fate = foresee(saddle, end, isPassed);
        if (fate == Fate::Dies) continue;
        if (fate == Fate::Lasts) {
          ++decided_;
          return found_ = true;
        }
      }
      if (!isPassed) return false;
      if (!measure(frontier)) return true;
      if (saddle.isOpenToRounding) return false;
    }
    if (saddle.death - height > persistence_) {
      ++decided_;
      return found_ = true;
    }
  }
  return false;
}

void PersistentSearch::add(const LoopCandidate& loop) {
  const double height = loop.length / 2;
  findArrivals(*propagation_, loop.halfedge, loop.midpoint, height * (1 + kTogether), arrivals_);
  work_ += arrivals_.paths.size();
  if (saddles_.empty()) {
    // Maxima are looked for from the first saddle on.
    measured_ = height * (1 - 4 * kTogether);
    propagation_->keepBeyond(measured_);
  }
  if (arrivals_.vertex != kNoIndex) return addAtVertex(loop);
  const bool isPlain = arrivals_.paths.size() == 2;
  if (isPlain || divides(loop)) push({loop, kInfinity, isPlain, kNoIndex});
}

void PersistentSearch::push(const Saddle& saddle) {
  if (!isKnown(saddle)) saddles_.push_back(saddle);
}

/// A loop whose midpoint is a vertex, up to rounding: where k gaps of π part the paths that arrive
/// there, k - 1 saddles. No more than one where paths cannot part at the vertex. Otherwise one half
/// of each loop is the path that is stored for the vertex.
void PersistentSearch::addAtVertex(const LoopCandidate& loop) {
  const Index vertex = arrivals_.vertex;
  arrivals_.surround(kFullGap);  // sorts
  if (!pathOrder_.bends(vertex) || !propagation_->settled(vertex)) {
    if (gapsBeside(0, 0).around > 1) push({loop, kInfinity, false, vertex});
    return;
  }
  if (loop.there.vertex == vertex || loop.back.vertex == vertex) {
    const bool isStored = loop.there.vertex == vertex;
    addAtVertex(loop, directionOf(loop, isStored ? loop.there : loop.back),
                directionOf(loop, isStored ? loop.back : loop.there));
    return;
  }
  // Rounding has it pass beside the vertex.
  const Unfolding& unfolding = propagation_->unfolding();
  const double stored = propagation_->arrivalDirection(vertex);
  for (const PathArrival& path : arrivals_.paths) {
    LoopCandidate through{loop.length, {{}, vertex}, path.half, 0, {}};
    if (path.half.bundle.halfedge != kNoIndex) {
      through.halfedge = path.half.bundle.halfedge;
      through.midpoint = unfolding.crossing(through.halfedge).apex();
    } else {
      const auto fan = unfolding.fan(vertex);
      const auto edge = std::find_if(fan.begin(), fan.end(), [&](Index h) {
        return unfolding.crossing(h).to() == path.half.vertex;
      });
      const bool isLast = edge == fan.end();  // before a boundary
      through.halfedge = isLast ? Unfolding::previous(fan.back()) : *edge;
      if (isLast) through.midpoint = {unfolding.crossing(through.halfedge).length(), 0};
    }
    addAtVertex(through, stored, path.direction);
  }
}

/// One of the loops through a vertex, by the directions of the path stored there and of the other.
void PersistentSearch::addAtVertex(const LoopCandidate& loop, double stored, double other) {
  const Index vertex = arrivals_.vertex;
  const bool isSwapped = stored > other;
  const Gaps gaps = gapsBeside(std::min(stored, other), std::max(stored, other));
  if (gaps.between == 0 || gaps.around == 0) return;
  const AtVertex here{vertex, isSwapped ? gaps.around : gaps.between};
  for (const AtVertex& known : atVertices_) {
    if (known.vertex == here.vertex && known.gaps == here.gaps) return;
  }
  atVertices_.push_back(here);
  push({loop, kInfinity, false, vertex});
}

/// Whether it has been found already, in another face, or by another path that arrives in the same
/// direction. A point has one saddle, but for vertices at which paths may part.
bool PersistentSearch::isKnown(const Saddle& saddle) const {
  const LoopCandidate& loop = saddle.loop;
  const Unfolding& unfolding = propagation_->unfolding();
  if (saddle.vertex != kNoIndex && pathOrder_.bends(saddle.vertex)) return false;
  const Index face = faceOfSide(loop.halfedge);
  const auto isThere = [&](Index halfedge, Vec2 point, const LoopCandidate& known) {
    const Vec2 off = unfolding.toFrame(halfedge, known.halfedge, point) - known.midpoint;
    return norm(off) <= kTogether * known.length;
  };
  for (std::size_t i = saddles_.size(); i-- > 0;) {
    const Saddle& known = saddles_[i];
    if (known.loop.length < loop.length * (1 - 4 * kTogether)) return false;
    if (saddle.vertex != known.vertex) continue;
    if (saddle.vertex != kNoIndex) return true;
    const Index knownFace = faceOfSide(known.loop.halfedge);
    if (knownFace == face && isThere(loop.halfedge, loop.midpoint, known.loop)) return true;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index twin = unfolding.twin(h);
      if (twin == kNoIndex || faceOfSide(twin) != knownFace) continue;
      const Vec2 at = unfolding.toFrame(loop.halfedge, h, loop.midpoint);
      if (isThere(twin, unfolding.toTwin(h, at), known.loop)) return true;
    }
  }
  return false;
}

/// The paths of all loops.
void PersistentSearch::findEnds() {
  while (ends_.size() < saddles_.size()) {
    const LoopCandidate& loop = saddles_[ends_.size()].loop;
    ends_.push_back({loop.length / 2, pathOrder_.ofHalf(loop, loop.there, loop.back),
                     pathOrder_.ofHalf(loop, loop.back, loop.there)});
    work_ += ends_.back().there.size() + ends_.back().back.size();
  }
}

/// Whether both sides of a loop go on at its midpoint, which is no vertex. Where a third path
/// arrives there as well, one side may be filled at once: a saddle and a maximum in one, which has
/// no persistence.
bool PersistentSearch::divides(const LoopCandidate& loop) {
  leaveOutApart(loop);
  arrivals_.surround(kFullGap);  // sorts
  const double there = directionOf(loop, loop.there), back = directionOf(loop, loop.back);
  const Gaps gaps = gapsBeside(std::min(there, back), std::max(there, back));
  return gaps.between > 0 && gaps.around > 0;
}

/// The gaps of π between the paths that arrive: those whose middle lies between two directions, and
/// the others. Beyond a boundary is a way on.
PersistentSearch::Gaps PersistentSearch::gapsBeside(double from, double to) const {
  const std::vector<PathArrival>& paths = arrivals_.paths;
  Gaps gaps;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const bool isLast = i + 1 == paths.size();
    const double a = paths[i].direction;
    const double b = isLast ? paths.front().direction + arrivals_.total : paths[i + 1].direction;
    if (isLast && arrivals_.open) {
      ++gaps.around;
    } else if (b - a >= kFullGap) {
      // Rounding has a path along the first direction arrive at 0 or at the total.
      const double middle = std::fmod((a + b) / 2, arrivals_.total);
      ++(middle > from && middle < to ? gaps.between : gaps.around);
    }
  }
  return gaps;
}

/// Takes paths from the arrivals that meet the two halves of a loop so far beside its midpoint that
/// there is a maximum of its own, if the frontier vanishes there: as far as the two then leave less
/// than kNoGap on the side of the loop.
void PersistentSearch::leaveOutApart(const LoopCandidate& loop) {
  const double height = loop.length / 2;
  const double from = directionOf(loop, loop.there);
  const double bend = 1 / norm(rootOf(loop, loop.there) - loop.midpoint) +
                      1 / norm(rootOf(loop, loop.back) - loop.midpoint);
  std::erase_if(arrivals_.paths, [&](const PathArrival& path) {
    const double later = path.length - height * (1 + geodesic::kRounding);
    // The angle between the path and the nearer half, for its sine: at most half as much again.
    const double apart = std::fabs(path.direction - from);
    const double off = std::min({apart, std::fabs(apart - kPi), 2 * kPi - apart});
    return later * bend > (kPi - kNoGap) * off;
  });
}

/// The fate of a saddle, as far as its two sides show: whether both lead farther than `end`, or
/// one of them is filled up to there.
PersistentSearch::Fate PersistentSearch::foresee(const Saddle& saddle, double end, bool isPassed) {
  if (!saddle.isPlain || isBesideCorner(saddle)) return Fate::Unknown;
  const LoopCandidate& loop = saddle.loop;
  const double height = loop.length / 2;
  const std::array<Vec2, 2> roots{rootOf(loop, loop.there), rootOf(loop, loop.back)};
  const Vec2 line = roots[1] - roots[0];
  const auto side = [&](std::size_t k) {
    return SaddleSide{loop.halfedge, loop.midpoint, roots,
                      k == 0 ? Vec2{-line.y, line.x} : Vec2{line.y, -line.x}};
  };
  // A side that does not lead on at once is filled, as a rule.
  if (isPassed && !withDeaths_ && isAlone(saddle)) {
    for (const std::size_t k : {0, 1}) {
      if (leads_[k]) continue;
      const bool isFilled = ascent_.isFilled(side(k), height, end);
      work_ += ascent_.work();
      if (isFilled) return Fate::Dies;
    }
  }
  for (const std::size_t k : {0, 1}) {
    if (!leads_[k]) {
      leads_[k] = ascent_.leads(side(k), height, end);
      work_ += ascent_.work();
    }
    if (!leads_[k]) return Fate::Unknown;
  }
  return Fate::Lasts;
}

/// Whether the midpoint of a loop is so near to a corner of its face that what lies between them is
/// less than the walks on its sides can see.
bool PersistentSearch::isBesideCorner(const Saddle& saddle) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index face = faceOfSide(saddle.loop.halfedge);
  double nearest = kInfinity, longest = 0;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Vec2 at = unfolding.toFrame(saddle.loop.halfedge, h, saddle.loop.midpoint);
    nearest = std::min(nearest, norm(at));
    longest = std::max(longest, unfolding.crossing(h).length());
  }
  return nearest <= kSaddleOnSide * longest;
}

/// Whether no other saddle is as high, up to rounding.
bool PersistentSearch::isAlone(const Saddle& saddle) const {
  constexpr double kAsHigh = 1e-7;
  return std::count_if(saddles_.begin(), saddles_.end(), [&](const Saddle& other) {
           return std::fabs(other.loop.length - saddle.loop.length) <= kAsHigh * saddle.loop.length;
         }) == 1;
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
    if (half.vertex != kNoIndex) return pathOrder_.directionOfEdge(vertex, half.vertex);
  }
  return arrivals_.directionTo(unfolding, loop.halfedge, loop.midpoint, rootOf(loop, half));
}

/// Where a half of a loop comes from, in the frame of the loop.
Vec2 PersistentSearch::rootOf(const LoopCandidate& loop, const PathHalf& half) const {
  const Unfolding& unfolding = propagation_->unfolding();
  if (half.bundle.halfedge != kNoIndex) {
    return unfolding.toFrame(half.bundle.halfedge, loop.halfedge, half.bundle.root);
  }
  const Index face = faceOfSide(loop.halfedge);
  if (half.vertex != kNoIndex) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (unfolding.crossing(h).from() == half.vertex) {
        return unfolding.toFrame(h, loop.halfedge, {0, 0});
      }
    }
  }
  for (const geodesic::Propagation::Origin& origin : propagation_->origins()) {
    if (origin.face == face) return unfolding.toFrame(3 * face, loop.halfedge, origin.place);
  }
  return loop.midpoint;
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
  findEnds();
  // The first of several saddles that are one counts.
  std::vector<std::size_t> numbers;
  std::vector<SaddleEnds> ends;
  std::vector<LocalMaximum> maxima = maxima_;
  std::vector<bool> isBesideLower;  // maximum; of those in `ends`
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const SaddleEnds& saddle = ends_[i];
    if (i >= decided_) saddles_[i].death = saddle.height;
    const auto one = std::find_if(ends.rbegin(), ends.rend(),
                                  [&](const SaddleEnds& other) { return areOne(other, saddle); });
    const std::size_t lower = std::erase_if(
        maxima, [&](const LocalMaximum& maximum) { return isLower(maximum, saddle); });
    if (one != ends.rend()) {
      std::erase_if(
          maxima, [&](const LocalMaximum& maximum) { return liesBetween(maximum, *one, saddle); });
      continue;
    }
    numbers.push_back(i);
    ends.push_back(saddle);
    isBesideLower.push_back(lower > 0);
  }
  const std::vector<double> deaths = saddleDeaths(ends, maxima, boundaries_, isComplete);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::size_t i = numbers[k];
    if (i < decided_) continue;
    const bool isLate = deaths[k] > ends[k].height * (1 + 4 * kTogether);
    if (isLate) saddles_[i].death = deaths[k];
    const bool isTie = isBesideLower[k] || !(saddles_[i].isPlain || saddles_[i].vertex != kNoIndex);
    saddles_[i].isOpenToRounding = !isComplete && (!isLate || (isTie && std::isinf(deaths[k])));
  }
  return true;
}

/// Whether rounding has made two saddles of one: they are equally high, their loops run beside each
/// other, and no higher maximum lies between. Their order would be a matter of rounding.
bool PersistentSearch::areOne(const SaddleEnds& a, const SaddleEnds& b) const {
  const double high = a.height * (1 + 4 * kTogether);
  if (b.height > high) return false;
  if (!runAlike(a, b) &&
      !(pathOrder_.runBeside(a.there, b.back) && pathOrder_.runBeside(a.back, b.there))) {
    return false;
  }
  return std::none_of(maxima_.begin(), maxima_.end(), [&](const LocalMaximum& maximum) {
    return maximum.distance > high && liesBetween(maximum, a, b);
  });
}

/// Whether a maximum beside a saddle is no higher, and so an effect of rounding.
bool PersistentSearch::isLower(const LocalMaximum& maximum, const SaddleEnds& saddle) const {
  return maximum.distance <= saddle.height &&
         maximum.distance >= saddle.height * (1 - 4 * kTogether) &&
         (pathOrder_.runBeside(maximum.path, saddle.there) ||
          pathOrder_.runBeside(maximum.path, saddle.back));
}

bool PersistentSearch::runAlike(const SaddleEnds& a, const SaddleEnds& b) const {
  return pathOrder_.runBeside(a.there, b.there) && pathOrder_.runBeside(a.back, b.back);
}

/// Whether a maximum lies between two loops that run beside each other.
bool PersistentSearch::liesBetween(const LocalMaximum& maximum, const SaddleEnds& a,
                                   const SaddleEnds& b) const {
  const bool isAlike = runAlike(a, b);
  return PathOrder::liesBetween(maximum.path, a.there, isAlike ? b.there : b.back) ||
         PathOrder::liesBetween(maximum.path, a.back, isAlike ? b.back : b.there);
}

/// The paths to all boundary curves of the component.
void PersistentSearch::findBoundaries() {
  const Unfolding& unfolding = propagation_->unfolding();
  std::vector<bool> visited;
  for (const Index v : propagation_->reachedVertices()) {
    if (!unfolding.boundary(v)) continue;
    if (visited.empty()) visited.resize(unfolding.vertexCount(), false);
    if (visited[v]) continue;
    boundaries_.push_back(pathOrder_.beyondBoundary(v));
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
  for (const LocalMaximum& maximum : maxima_) bends += maximum.path.capacity();
  return maximaSearch_.memoryBytes() + ascent_.memoryBytes() +
         saddles_.capacity() * sizeof(Saddle) + ends_.capacity() * sizeof(SaddleEnds) +
         maxima_.capacity() * sizeof(LocalMaximum) + bends * sizeof(Bend);
}

}  // namespace girth
