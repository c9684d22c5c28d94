#include "solver/persistence/ascent.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "infinity.h"
#include "mesh/vector.h"
#include "solver/search/arrivals.h"

namespace girth {

using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTie;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;
using geodesic::Window;

namespace {

/// Distances this share apart are different for certain; by the second one, if they are as exact as
/// those of one face are. The narrow fans behind vertices of little more than 2π need that.
constexpr double kApart = 4 * kTogether, kAbove = 2 * kTie;
/// A shorter share of an edge is no piece of it; pieces are the same up to kSame of it.
constexpr double kLeastPiece = 1e-6, kSame = 1e-9;
constexpr std::size_t kMostPlaces = 256, kMostWork = std::size_t{1} << 18;
/// So many points are tried for being far from all that has been reached, within so many faces.
constexpr std::size_t kMostReached = 24, kMostAround = 512;
/// So many faces are passed straight.
constexpr std::size_t kMostStraight = 128;

std::array<Index, 3> sidesOf(Index halfedge) {
  return {halfedge, Unfolding::next(halfedge), Unfolding::previous(halfedge)};
}

/// A straight piece of a way within a face, as seen from one of its halfedges.
struct Straight {
  Vec2 from, to;
  bool isFirst;  // begins at the saddle
};

/// Whether the paths of length sigma + |root − x| to the points x of a part of a straight piece,
/// from one share of it to another, are all longer than `low`.
bool areLonger(const Straight& piece, double begin, double end, Vec2 root, double sigma,
               double low) {
  const Vec2 along = piece.to - piece.from, start = piece.from - root;
  const double square = dot(along, along);
  const double nearest = square > 0 ? -dot(start, along) / square : 0;
  const double length = sigma + norm(start + std::clamp(nearest, begin, end) * along);
  if (length > low * (1 + kAbove)) return true;
  // Paths that arrive at the saddle itself become longer from there on.
  return piece.isFirst && nearest <= kTouch && length >= low * (1 - kApart);
}

/// The part of a straight piece that a window covers, up to kTouch of its halfedge: from one share
/// of it to another. False: none.
bool findCovered(const Window& w, double length, const Straight& piece, double& begin,
                 double& end) {
  begin = 0;
  end = 1;
  const Vec2 from = piece.from - w.root, to = piece.to - w.root;
  const double slack = kTouch * length * (norm(from) + norm(to));
  const auto keepPositive = [&](double atFrom, double atTo) {
    atFrom += slack;
    atTo += slack;
    if (atFrom < 0 && atTo < 0) return false;
    if (atFrom < 0) begin = std::max(begin, atFrom / (atFrom - atTo));
    if (atTo < 0) end = std::min(end, atFrom / (atFrom - atTo));
    return begin <= end;
  };
  const Vec2 left = Vec2{w.gapFrom, 0} - w.root, right = Vec2{length - w.gapTo, 0} - w.root;
  return keepPositive(cross(from, left), cross(to, left)) &&
         keepPositive(cross(right, from), cross(right, to));
}

}  // namespace

void Ascent::start(double low, double high) {
  low_ = low;
  high_ = high;
  found_ = false;
  work_ = 0;
  places_.clear();
  seen_.clear();
  heap_.clear();
}

bool Ascent::leads(const SaddleSide& side, double low, double high) {
  const Unfolding& unfolding = propagation_->unfolding();
  // A saddle that lasts no longer than that is not seen to last.
  high = std::max(high, low * (1 + 2 * kApart));
  start(low, high);
  origin_ = positionOf(unfolding.mesh(), unfolding.toMesh(propagation_->source(0)));
  // With what rounding takes from coordinates far from 0.
  const double rounding = kTie * girth::norm(origin_);
  straight_ = high * (1 + kApart) * unfolding.unit() + rounding;
  radius_ = (high - low + 2 * kApart * high) * unfolding.unit() + rounding;
  isPassed_ = high * (1 + 2 * kApart) < propagation_->frontier();
  const Crossing c = unfolding.crossing(side.halfedge);
  reached_.assign(1, positionOn(side.halfedge, std::clamp(side.point.x, 0.0, c.length())));

  goStraight(side);
  if (found_) return true;
  setOut(side);
  // On a side of the face, the saddle is in the face beyond as well.
  for (const Index h : sidesOf(side.halfedge)) {
    const Vec2 at = unfolding.toFrame(side.halfedge, h, side.point);
    if (unfolding.twin(h) == kNoIndex || at.y > kTouch * unfolding.crossing(h).length()) continue;
    setOut(beyond(side, h));
  }
  while (!found_ && !heap_.empty() && places_.size() < kMostPlaces && work_ < kMostWork) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Place place = places_[heap_.back().second];
    heap_.pop_back();
    goOn(place);
  }
  return found_;
}

/// Straight on from the saddle, at right angles to its loop, as far as that leads: most ways need
/// no turns.
void Ascent::goStraight(const SaddleSide& side) {
  const Unfolding& unfolding = propagation_->unfolding();
  Index entry = kNoIndex, in = side.halfedge;
  Vec2 from = side.point, direction = side.direction;
  bool isFirst = true;
  for (std::size_t i = 0; i < kMostStraight; ++i) {
    Index exit = kNoIndex;
    double at = 0;
    for (const Index h : sidesOf(in)) {
      if (h == entry) continue;
      const Vec2 start = unfolding.toFrame(in, h, from);
      const Vec2 ahead = unfolding.toFrame(in, h, from + direction) - start;
      if (!(ahead.y < 0)) continue;
      // A saddle that rounding has put beyond the side leaves at once, and never backwards.
      const double x = start.x - std::min(start.y / ahead.y, 0.0) * ahead.x;
      if (!(x > 0 && x < unfolding.crossing(h).length())) continue;
      exit = h;
      at = x;
    }
    if (exit == kNoIndex) return;
    if (!isClear(in, from, unfolding.toFrame(exit, in, {at, 0}), isFirst)) return;
    const Index twin = unfolding.twin(exit);
    found_ = twin == kNoIndex || isFarther(exit, at);
    if (found_) return;
    const Vec2 end = unfolding.toFrame(in, exit, from + direction);
    const Vec2 start = unfolding.toFrame(in, exit, from);
    // A saddle on a side of the face is in the face beyond, too.
    isFirst = isFirst && start.y <= kTouch * unfolding.crossing(exit).length();
    from = unfolding.toTwin(exit, {at, 0});
    direction = unfolding.toTwin(exit, Vec2{at, 0} + (end - start)) - from;
    entry = in = twin;
  }
}

/// Whether every point of a straight piece within the face of a halfedge, but the saddle, is
/// farther than that.
bool Ascent::isClear(Index halfedge, Vec2 from, Vec2 to, bool isFirst) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index face = faceOfSide(halfedge);
  if (propagation_->forgotten(face)) return false;
  for (const Index h : sidesOf(halfedge)) {
    const Crossing c = unfolding.crossing(h);
    const Straight piece{unfolding.toFrame(halfedge, h, from), unfolding.toFrame(halfedge, h, to),
                         isFirst};
    if (propagation_->settled(c.from()) &&
        !areLonger(piece, 0, 1, {0, 0}, propagation_->distance(c.from()), low_)) {
      return false;
    }
    work_ += propagation_->enteredCount(h);
    double begin = 0, end = 0;
    if (propagation_->findEntered(h, [&](const Window& w, std::uint32_t) {
          return !w.isSurelyLonger(c.length(), low_) &&
                 findCovered(w, c.length(), piece, begin, end) &&
                 !areLonger(piece, begin, end, w.root, w.sigma, low_);
        })) {
      return false;
    }
  }
  const auto& origins = propagation_->origins();
  return std::all_of(origins.begin(), origins.end(), [&](const Propagation::Origin& origin) {
    const Vec2 place = unfolding.toFrame(3 * origin.face, halfedge, origin.place);
    return origin.face != face || areLonger({from, to, isFirst}, 0, 1, place, 0, low_);
  });
}

/// A side of a saddle on a halfedge as it is in the face beyond.
SaddleSide Ascent::beyond(const SaddleSide& side, Index halfedge) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const auto place = [&](Vec2 p) {
    return unfolding.toTwin(halfedge, unfolding.toFrame(side.halfedge, halfedge, p));
  };
  const Vec2 at = unfolding.toFrame(side.halfedge, halfedge, side.point);
  return {unfolding.twin(halfedge),
          unfolding.toTwin(halfedge, {at.x, 0}),
          {place(side.roots[0]), place(side.roots[1])},
          place(side.point + side.direction) - place(side.point)};
}

/// From the saddle to the sides of one of its faces.
void Ascent::setOut(const SaddleSide& side) {
  if (propagation_->forgotten(faceOfSide(side.halfedge))) return;
  rest_.findBeside(*propagation_, side, low_ * (1 + kAbove), low_ * (1 + kAbove));
  work_ += rest_.takeWork();
  const std::size_t gap = rest_.saddleGap();
  for (const SuperlevelPieces::Piece& piece : rest_.pieces()) {
    if (!found_ && !isKnown(piece) && rest_.together(gap, piece.gap)) reach(piece);
  }
}

/// From a piece of an edge into the face beyond, and to the pieces of its sides.
void Ascent::goOn(const Place& place) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index twin = unfolding.twin(place.halfedge);
  const Index face = faceOfSide(twin);
  if (propagation_->forgotten(face)) return;
  const double height = low_ * (1 + kAbove);
  rest_.find(*propagation_, face, height, isPassed_ ? high_ * (1 + kApart) : height);
  work_ += rest_.takeWork();
  const double at = unfolding.crossing(twin).length() - place.middle();
  const auto& pieces = rest_.pieces();
  const auto from =
      std::find_if(pieces.begin(), pieces.end(), [&](const SuperlevelPieces::Piece& piece) {
        return piece.halfedge == twin && piece.begin < at && at < piece.end;
      });
  if (from == pieces.end()) return;
  if (rises(*from)) {
    found_ = true;
    return;
  }
  for (const SuperlevelPieces::Piece& piece : pieces) {
    if (!found_ && !isKnown(piece) && rest_.together(*from, piece)) reach(piece);
  }
}

/// Whether a point of the face is farther than `high` and hangs together with a piece.
bool Ascent::rises(const SuperlevelPieces::Piece& from) {
  const Index face = faceOfSide(from.halfedge);
  if (!isPassed_ || propagation_->farthestWithin(face) <= high_) return false;
  upper_.find(*propagation_, face, high_ * (1 + kApart), high_ * (1 + kApart));
  work_ += upper_.takeWork();
  const Unfolding& unfolding = propagation_->unfolding();
  const auto& pieces = rest_.pieces();
  for (const SuperlevelPieces::Piece& upper : upper_.pieces()) {
    if (upper.end - upper.begin < kLeastPiece * unfolding.crossing(upper.halfedge).length()) {
      continue;
    }
    const double at = (upper.begin + upper.end) / 2;
    if (std::any_of(pieces.begin(), pieces.end(), [&](const SuperlevelPieces::Piece& piece) {
          return piece.halfedge == upper.halfedge && piece.begin < at && at < piece.end &&
                 rest_.together(from, piece);
        })) {
      return true;
    }
  }
  if (rest_.isWithin(high_ * (1 + kApart)) || !rest_.above()) return false;
  return std::any_of(pieces.begin(), pieces.end(), [&](const SuperlevelPieces::Piece& piece) {
    return rest_.together(from, piece) && rest_.isClear(piece, *rest_.above());
  });
}

/// Whether a piece is too short to count, or a way has been there.
bool Ascent::isKnown(const SuperlevelPieces::Piece& piece) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const double length = unfolding.crossing(piece.halfedge).length();
  if (piece.end - piece.begin < kLeastPiece * length) return true;
  const double at = (piece.begin + piece.end) / 2;
  const Index twin = unfolding.twin(piece.halfedge);
  return isKnown(places_, piece.halfedge, at, at) ||
         (twin != kNoIndex && isKnown(places_, twin, length - at, length - at));
}

/// Notes a piece that a way leads to.
void Ascent::reach(const SuperlevelPieces::Piece& piece) {
  const Place place{piece.halfedge, piece.begin, piece.end};
  const double at = place.middle();
  found_ =
      propagation_->unfolding().twin(piece.halfedge) == kNoIndex || isFarther(piece.halfedge, at);
  heap_.push_back({fromReached(positionOn(piece.halfedge, at)), places_.size()});
  std::push_heap(heap_.begin(), heap_.end());
  places_.push_back(place);
}

/// Whether a part of a halfedge lies in one of these places, up to rounding.
bool Ascent::isKnown(const std::vector<Place>& places, Index halfedge, double begin,
                     double end) const {
  const double same = kSame * propagation_->unfolding().crossing(halfedge).length();
  return std::any_of(places.begin(), places.end(), [&](const Place& known) {
    return known.halfedge == halfedge && begin >= known.begin - same && end <= known.end + same;
  });
}

/// Whether a point of a halfedge is seen to be farther than `high`, as it lies far off.
bool Ascent::isFarther(Index halfedge, double at) {
  const Vec3 point = positionOn(halfedge, at);
  return squareOf(point - origin_) > straight_ * straight_ ||
         (!isPassed_ && isFarFromAll(halfedge, point));
}

/// How far a point is, in space, from what is known to have been reached.
double Ascent::fromReached(Vec3 point) const {
  double nearest = kInfinity;
  for (const Vec3 reached : reached_) nearest = std::min(nearest, squareOf(point - reached));
  return std::sqrt(nearest);
}

/// Whether nothing within high − low of a point of a halfedge has been reached up to `low`. Points
/// so near are so near in space, too, and hang together across edges that are.
bool Ascent::isFarFromAll(Index halfedge, Vec3 point) {
  if (reached_.size() > kMostReached) return false;
  // The point that was found last is the nearest, as a rule.
  for (std::size_t i = reached_.size(); i-- > 0;) {
    if (squareOf(point - reached_[i]) <= radius_ * radius_) return false;
  }
  const Unfolding& unfolding = propagation_->unfolding();
  if (turn_.empty()) turn_.resize(unfolding.halfedgeCount() / 3, 0);
  if (++turns_ == 0) {
    std::fill(turn_.begin(), turn_.end(), 0u);
    turns_ = 1;
  }
  around_.clear();
  const auto add = [&](Index h) {
    const Index face = faceOfSide(h);
    if (turn_[face] == turns_) return;
    turn_[face] = turns_;
    around_.push_back(face);
  };
  add(halfedge);
  if (const Index twin = unfolding.twin(halfedge); twin != kNoIndex) add(twin);
  for (std::size_t i = 0; i < around_.size(); ++i) {
    const Index face = around_[i];
    ++work_;
    if (i == kMostAround || !isUnreached(face)) {
      reached_.push_back(cornerOf(unfolding.crossing(3 * face).from()));
      return false;
    }
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index twin = unfolding.twin(h);
      if (twin == kNoIndex || turn_[faceOfSide(twin)] == turns_) continue;
      const Crossing c = unfolding.crossing(h);
      const Vec3 from = cornerOf(c.from()), to = cornerOf(c.to());
      if (squareFromSegment(point, from, to) <= radius_ * radius_) add(twin);
    }
  }
  return true;
}

/// Whether every point of a face is farther than `low`.
bool Ascent::isUnreached(Index face) const {
  if (propagation_->forgotten(face)) return false;
  const Unfolding& unfolding = propagation_->unfolding();
  const double low = low_ * (1 + kAbove);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing c = unfolding.crossing(h);
    if (!(propagation_->distance(c.from()) > low)) return false;
    if (propagation_->findEntered(
            h, [&](const Window& w, std::uint32_t) { return !(w.nearest(c.length()) > low); })) {
      return false;
    }
  }
  const auto& origins = propagation_->origins();
  return std::none_of(origins.begin(), origins.end(),
                      [&](const Propagation::Origin& origin) { return origin.face == face; });
}

bool Ascent::isFilled(const SaddleSide& side, double low, double high) {
  const Unfolding& unfolding = propagation_->unfolding();
  start(low, high);
  const double height = low * (1 - kApart), most = high * (1 - kApart);
  SaddleSide beside = side;
  const auto seesWhole = [&](const SaddleSide& in) {
    beside = in;
    return !propagation_->forgotten(faceOfSide(in.halfedge)) &&
           rest_.findBeside(*propagation_, in, height, most);
  };
  const std::array<Index, 3> sides = sidesOf(side.halfedge);
  // Where the loop runs along a side of the face, one side of it is in the face beyond.
  if (!seesWhole(side) && std::none_of(sides.begin(), sides.end(), [&](Index h) {
        const Vec2 at = unfolding.toFrame(side.halfedge, h, side.point);
        return unfolding.twin(h) != kNoIndex && at.y <= kTouch * unfolding.crossing(h).length() &&
               seesWhole(beyond(side, h));
      })) {
    return false;
  }
  if (!rest_.isWithin(most)) return false;
  gaps_.clear();
  gaps_.push_back(rest_.saddleGap());
  addEntered();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (i == kMostPlaces || work_ > kMostWork) return false;
    const Place place = places_[i];
    const Index twin = unfolding.twin(place.halfedge);
    if (twin == kNoIndex) return false;
    const Index face = faceOfSide(twin);
    if (propagation_->forgotten(face)) {
      // It is nearer than what was kept last; a saddle below that may have a side that leads on
      // there.
      if (propagation_->farthestWithin(face) <= height) continue;
      return false;
    }
    if (face != faceOfSide(beside.halfedge)) {
      rest_.find(*propagation_, face, height, most);
      if (propagation_->farthestWithin(face) > most && !rest_.isWithin(most)) return false;
      enter(place);
      addEntered();
      continue;
    }
    // Back beside the loop, where it must not come to the saddle from the other side.
    for (const bool isOther : {false, true}) {
      SaddleSide part = beside;
      if (isOther) part.direction = -1 * part.direction;
      const bool isWhole = rest_.findBeside(*propagation_, part, height, most);
      if (!isWhole || !rest_.isWithin(most)) return false;
      enter(place);
      if (isOther && isEntered(rest_.saddleGap())) return false;
      addEntered();
    }
  }
  return true;
}

/// The gaps of the face beyond a place that lie at it.
void Ascent::enter(const Place& place) {
  const Unfolding& unfolding = propagation_->unfolding();
  const Index twin = unfolding.twin(place.halfedge);
  const double length = unfolding.crossing(twin).length(), same = kSame * length;
  const double begin = length - place.end - same, end = length - place.begin + same;
  gaps_.clear();
  for (const SuperlevelPieces::Piece& piece : rest_.pieces()) {
    if (piece.halfedge == twin && piece.begin <= end && piece.end >= begin) {
      gaps_.push_back(piece.gap);
    }
  }
}

/// Whether a gap hangs together with one of those.
bool Ascent::isEntered(std::size_t gap) {
  return std::any_of(gaps_.begin(), gaps_.end(),
                     [&](std::size_t from) { return rest_.together(from, gap); });
}

/// The pieces that hang together with them lead on, unless they lead back into what has been seen.
void Ascent::addEntered() {
  const Unfolding& unfolding = propagation_->unfolding();
  for (const SuperlevelPieces::Piece& piece : rest_.pieces()) {
    if (!isEntered(piece.gap)) continue;
    seen_.push_back({piece.halfedge, piece.begin, piece.end});
    const Index twin = unfolding.twin(piece.halfedge);
    const double length = unfolding.crossing(piece.halfedge).length();
    if (twin != kNoIndex && (isKnown(seen_, twin, length - piece.end, length - piece.begin) ||
                             isKnown(places_, piece.halfedge, piece.begin, piece.end))) {
      continue;
    }
    places_.push_back({piece.halfedge, piece.begin, piece.end});
  }
  work_ += rest_.takeWork();
}

/// A point of a halfedge in space, in model units.
Vec3 Ascent::positionOn(Index halfedge, double at) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const Crossing c = unfolding.crossing(halfedge);
  const Vec3 from = cornerOf(c.from());
  return from + at / c.length() * (cornerOf(c.to()) - from);
}

/// A vertex in space, in model units.
Vec3 Ascent::cornerOf(Index vertex) const {
  const Unfolding& unfolding = propagation_->unfolding();
  return unfolding.mesh().position(Vertex(unfolding.vertexInMesh(vertex)));
}

std::size_t Ascent::memoryBytes() const {
  return rest_.memoryBytes() + upper_.memoryBytes() +
         (places_.capacity() + seen_.capacity()) * sizeof(Place) +
         heap_.capacity() * sizeof(heap_.front()) + reached_.capacity() * sizeof(Vec3) +
         around_.capacity() * sizeof(Index) + turn_.capacity() * sizeof(turn_.front()) +
         gaps_.capacity() * sizeof(std::size_t);
}

}  // namespace girth
