#include "loops/tight/taut_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geodesic/tolerances.h"
#include "loops/tight/pulling.h"
#include "loops/tight/rounding_guard.h"

namespace girth::loops {
namespace {

using geodesic::kTaut;
using geodesic::kTouch;

/// Halvings of an edge until its share is known well enough to tell which vertices are passed.
constexpr int kHalvings = 45;

Passage passageAt(const Unfolding& unfolding, const TautLoop& loop, std::size_t i) {
  const std::size_t size = loop.vertices.size(), before = (i + size - 1) % size;
  return passageOf(unfolding, vertexNode(loop.vertices[before]), loop.runs[before],
                   loop.vertices[i], loop.runs[i], vertexNode(loop.vertices[(i + 1) % size]));
}

/// The loop that begins and ends at a vertex beside a closed run, from behind a portal round to it.
TautLoop pinned(const Unfolding& unfolding, const Run& run, Index vertex, std::size_t portal) {
  Run opened;
  for (std::size_t i = 1; i <= run.size(); ++i) opened.push_back(run[(portal + i) % run.size()]);
  TautLoop loop;
  loop.vertices.push_back(vertex);
  pull(unfolding, vertexNode(vertex), std::move(opened), vertexNode(vertex), loop.vertices,
       loop.runs);
  return loop;
}

/// The line along which a closed strip can be gone round straight on, and the corner on the left
/// that limits it: the nearest of those at the portals.
struct Straight {
  Vec2 at, along;
  std::size_t corner{0};
  double room{0};
};

Straight straightThrough(const Strip& strip, Vec2 at) {
  const std::size_t last = strip.portals() - 1;
  Vec2 step = strip.corner(strip.right(last)).place - strip.corner(strip.right(0)).place;
  Straight line{at, (1 / norm(step)) * step, 0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < last; ++i) {
    const double room = cross(line.along, strip.corner(strip.left(i)).place - at);
    if (room < line.room) {
      line.room = room;
      line.corner = strip.left(i);
    }
  }
  return line;
}

/// The corner through which the shortest loop of a closed strip is drawn that goes from a point of
/// its first edge straight to the same point of its last: one on the right that it touches, which
/// keeps it from getting shorter; otherwise the nearest on the left.
std::size_t besideLine(const Strip& strip, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  std::size_t corner = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < strip.portals(); ++i) {
    const double room = cross(along, strip.corner(strip.left(i)).place - a);
    if (room >= least) continue;
    least = room;
    corner = strip.left(i);
  }
  least = std::min(least, kTouch * dot(along, along));
  for (std::size_t i = 0; i + 1 < strip.portals(); ++i) {
    const double room = cross(along, a - strip.corner(strip.right(i)).place);
    if (room >= least) continue;
    least = room;
    corner = strip.right(i);
  }
  return corner;
}

/// A closed run begun at the edge that reaches farthest across it. Along an edge that runs with the
/// loop the length hardly changes, and rounding would decide where it is least.
Run begunAcross(const Unfolding& unfolding, const Run& run) {
  const Strip strip(unfolding, run, true);
  const auto place = [&](std::size_t corner) { return strip.corner(corner).place; };
  const Vec2 along = place(strip.right(run.size())) - place(strip.right(0));
  std::size_t first = 0;
  double widest = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double width = cross(along, place(strip.left(i)) - place(strip.right(i)));
    if (width <= widest) continue;
    widest = width;
    first = i;
  }
  Run begun = run;
  std::rotate(begun.begin(), begun.begin() + static_cast<std::ptrdiff_t>(first), begun.end());
  return begun;
}

/// The line in the middle of the straight ones that a closed strip can be gone round on, from a
/// point of its first edge to the same point of its last. Nothing where there is none but one that
/// touches a vertex.
std::optional<std::pair<Vec2, Vec2>> floatingLine(const Strip& strip) {
  const std::size_t last = strip.portals() - 1;
  const auto place = [&](std::size_t corner) { return strip.corner(corner).place; };
  const Vec2 right = place(strip.right(0)), left = place(strip.left(0));
  const Vec2 step = place(strip.right(last)) - right, leftStep = place(strip.left(last)) - left;
  const Vec2 edge = left - right, lastEdge = edge + leftStep - step;
  // Going round turns nothing: the line goes on in its own direction.
  if (dot(edge, lastEdge) <= 0 ||
      std::fabs(cross(edge, lastEdge)) >
          kTaut * std::sqrt(dot(edge, edge) * dot(lastEdge, lastEdge))) {
    return std::nullopt;
  }
  const double size = norm(step);
  if (!(size > kTouch * norm(edge))) return std::nullopt;
  const Vec2 along = (1 / size) * step;
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < last; ++i) {
    low = std::max(low, cross(along, place(strip.right(i)) - right));
    high = std::min(high, cross(along, place(strip.left(i)) - right));
  }
  if (!(high - low > kTouch * size)) return std::nullopt;
  const double share = (low + high) / 2 / cross(along, edge);
  const Vec2 start = right + share * edge;
  return std::pair{start, start + step + share * (leftStep - step)};
}

/// The shortest loop in a closed run, through a vertex beside it. The length of the shortest path
/// from a point of its first edge round to the same point is convex, so the least is found by
/// halving.
TautLoop closedLoop(const Unfolding& unfolding, const Run& anyRun) {
  const Run run = begunAcross(unfolding, anyRun);
  const Strip strip(unfolding, run, true);
  const std::size_t last = strip.portals() - 1;
  const Vec2 right = strip.corner(strip.right(0)).place, left = strip.corner(strip.left(0)).place;
  const Vec2 farRight = strip.corner(strip.right(last)).place,
             farLeft = strip.corner(strip.left(last)).place;
  double low = 0, high = 1;
  std::vector<std::size_t> bends;
  Vec2 a{}, b{};
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    a = right + middle * (left - right);
    b = farRight + middle * (farLeft - farRight);
    bends = strip.bends(a, 0, b, last - 1);
    const Vec2 first = bends.empty() ? b - a : strip.corner(bends.front()).place - a;
    const Vec2 end = bends.empty() ? b - a : b - strip.corner(bends.back()).place;
    const double slope =
        dot(end, farLeft - farRight) / norm(end) - dot(first, left - right) / norm(first);
    (slope < 0 ? low : high) = middle;
  }
  if (low >= 1 - kTouch || high <= kTouch) {
    const std::size_t corner = high <= kTouch ? strip.right(0) : strip.left(0);
    return pinned(unfolding, run, strip.corner(corner).vertex, strip.corner(corner).lastPortal);
  }
  const std::size_t corner = bends.empty() ? besideLine(strip, a, b) : bends.front();
  return pinned(unfolding, run, strip.corner(corner).vertex, strip.corner(corner).lastPortal);
}

/// A loop that passes its vertices number i, for which `passes` gives a side, on that side, not yet
/// pulled; closed runs have no vertices.
TautLoop pushedAside(const Unfolding& unfolding, const TautLoop& loop,
                     const std::vector<std::optional<Run>>& ways) {
  const std::size_t size = loop.vertices.size();
  std::size_t first = 0;
  while (first < size && ways[first]) ++first;
  TautLoop pushed;
  if (first == size) {  // no vertex stays
    pushed.runs.emplace_back();
    for (std::size_t i = 0; i < size; ++i) {
      Run& run = pushed.runs[0];
      run.insert(run.end(), ways[i]->begin(), ways[i]->end());
      run.insert(run.end(), loop.runs[i].begin(), loop.runs[i].end());
    }
    cancelReturns(unfolding, pushed.runs[0], true);
    return pushed;
  }
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = (first + k) % size;
    if (ways[i]) {
      Run& run = pushed.runs.back();
      run.insert(run.end(), ways[i]->begin(), ways[i]->end());
      run.insert(run.end(), loop.runs[i].begin(), loop.runs[i].end());
    } else {
      pushed.vertices.push_back(loop.vertices[i]);
      pushed.runs.push_back(loop.runs[i]);
    }
  }
  for (Run& run : pushed.runs) cancelReturns(unfolding, run, false);
  return pushed;
}

/// Whether loops that close straight within their strips stay there, without a vertex.
enum class Straights : bool { Pinned, Float };

/// The shortest loop in the strips of a loop.
TautLoop pulled(const Unfolding& unfolding, TautLoop loop, Straights straights) {
  if (loop.vertices.empty()) {
    if (loop.runs.empty() || loop.runs[0].size() < 2) return {};
    if (straights == Straights::Float) {
      Run begun = begunAcross(unfolding, loop.runs[0]);
      if (floatingLine(Strip(unfolding, begun, true))) return {{}, {std::move(begun)}};
    }
    return closedLoop(unfolding, loop.runs[0]);
  }
  TautLoop tight;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Index from = loop.vertices[i], to = loop.vertices[(i + 1) % loop.vertices.size()];
    tight.vertices.push_back(from);
    pull(unfolding, vertexNode(from), std::move(loop.runs[i]), vertexNode(to), tight.vertices,
         tight.runs);
  }
  return tight;
}

bool isPoint(const TautLoop& loop) {
  if (loop.vertices.empty()) return loop.runs.empty() || loop.runs[0].size() < 2;
  return loop.vertices.size() == 1 && loop.runs[0].empty();
}

/// Takes out runs that lead from a vertex to itself without crossing anything.
void dropPauses(TautLoop& loop) {
  for (std::size_t i = loop.vertices.size(); i-- > 0 && loop.vertices.size() > 1;) {
    const std::size_t next = (i + 1) % loop.vertices.size();
    if (!loop.runs[i].empty() || loop.vertices[i] != loop.vertices[next]) continue;
    loop.vertices.erase(loop.vertices.begin() + static_cast<std::ptrdiff_t>(i));
    loop.runs.erase(loop.runs.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::size_t sizeOf(const TautLoop& loop) {
  std::size_t size = loop.vertices.size();
  for (const Run& run : loop.runs) size += run.size();
  return size;
}

/// The loop the other way round.
TautLoop turnedRound(const Unfolding& unfolding, const TautLoop& loop) {
  TautLoop back;
  const std::size_t size = loop.vertices.size();
  for (std::size_t i = size; i-- > 0;) {
    back.vertices.push_back(loop.vertices[i]);
    back.runs.push_back(reversed(unfolding, loop.runs[(i + size - 1) % size]));
  }
  return back;
}

}  // namespace

std::optional<TautLoop> looseLoop(const Unfolding& unfolding,
                                  std::span<const SurfacePoint> points) {
  // Points inside faces lie between neighbours that share the face.
  std::vector<SurfacePoint> nodes;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].kind != SurfacePoint::Kind::InFace)
      nodes.push_back(unfolding.fromMesh(points[i]));
  }
  const auto lies = [&](const SurfacePoint& node, Index face) {
    for (Index k = 0; k < 3; ++k) {
      const Index side = 3 * face + k;
      if (node.kind == SurfacePoint::Kind::AtVertex
              ? unfolding.crossing(side).from() == node.element
              : side == node.element || unfolding.twin(side) == node.element) {
        return true;
      }
    }
    return false;
  };
  const std::size_t size = nodes.size();
  if (size < 2) return std::nullopt;
  // Begun behind a vertex, so that no run goes over the end.
  std::size_t first = 0;
  while (first < size && nodes[first].kind != SurfacePoint::Kind::AtVertex) ++first;
  const bool isClosed = first == size;
  if (isClosed) first = 0;
  TautLoop loop;
  if (isClosed) loop.runs.emplace_back();
  for (std::size_t k = 0; k < size; ++k) {
    const SurfacePoint& node = nodes[(first + k) % size];
    if (node.kind == SurfacePoint::Kind::AtVertex) {
      loop.vertices.push_back(node.element);
      loop.runs.emplace_back();
      continue;
    }
    const SurfacePoint& before = nodes[(first + k + size - 1) % size];
    const SurfacePoint& after = nodes[(first + k + 1) % size];
    const Index twin = unfolding.twin(node.element);
    if (twin == kNoIndex) return std::nullopt;
    const auto leads = [&](Index from, Index to) {
      return lies(before, faceOfSide(from)) && lies(after, faceOfSide(to));
    };
    if (leads(node.element, twin)) {
      loop.runs.back().push_back(node.element);
    } else if (leads(twin, node.element)) {
      loop.runs.back().push_back(twin);
    } else {
      return std::nullopt;
    }
  }
  return loop;
}

namespace {

/// A loop that is drawn tight step by step, with its passages.
class Tightening {
 public:
  Tightening(const Unfolding& unfolding, TautLoop& loop, Straights straights = Straights::Pinned)
      : unfolding_(unfolding), loop_(loop), straights_(straights) {
    measure();
  }

  Tightened run() {
    const std::size_t steps = mostSteps();
    for (std::size_t step = 0; step < steps; ++step) {
      if (isPoint(loop_)) return Tightened::Contracted;
      if (!passSharpest()) return Tightened::Geodesic;
    }
    return Tightened::GaveUp;
  }

  /// With time for as many steps as the surface has vertices to be passed.
  Tightened run(const ExecutionContext& context) {
    const std::size_t steps = mostSteps() + 10 * std::size_t{unfolding_.vertexCount()};
    RoundingGuard guard;
    for (std::size_t step = 0; step < steps && !context.cancelled(); ++step) {
      if (isPoint(loop_)) return Tightened::Contracted;
      const std::size_t sharpest = sharpestTurn(&guard);
      if (sharpest == passages_.size()) return Tightened::Geodesic;
      const Index vertex = loop_.vertices[sharpest];
      pass(sharpest);
      guard.passed(vertex, loop_.vertices.size(), [&] { return lengthOf(unfolding_, loop_); });
    }
    return Tightened::GaveUp;
  }

  /// In canonical form before each step, so that the next one depends on the curve alone.
  Tightened run(TightenedBefore& before) {
    const std::size_t steps = mostSteps();
    std::vector<TightenedBefore::Key> way;
    while (way.size() < steps) {
      if (isPoint(loop_)) {
        before.add(way, {Tightened::Contracted, nullptr, 0});
        return Tightened::Contracted;
      }
      TautLoop turned = canonical(unfolding_, loop_);
      if (turned != loop_) {
        loop_ = std::move(turned);
        measure();
      }
      way.push_back(TightenedBefore::keyOf(loop_));
      if (const auto known = before.find(way.back())) {
        way.pop_back();
        if (way.size() + known->steps >= steps) return Tightened::GaveUp;
        if (known->loop) loop_ = *known->loop;
        before.add(way, *known);
        return known->kind;
      }
      if (passSharpest()) continue;
      before.add(way, {Tightened::Geodesic, std::make_shared<const TautLoop>(loop_), 0});
      return Tightened::Geodesic;
    }
    return Tightened::GaveUp;
  }

 private:
  std::size_t mostSteps() const { return 1000 + 100 * sizeOf(loop_); }

  /// The vertex with the sharpest turn, by its place; `passages_.size()`: there is none.
  std::size_t sharpestTurn(const RoundingGuard* guard = nullptr) const {
    std::size_t sharpest = passages_.size();
    double least = kPi - kTaut;
    for (std::size_t i = 0; i < passages_.size(); ++i) {
      const double angle = std::min(passages_[i].left, passages_[i].right);
      if (angle >= least || (guard != nullptr && guard->isSettled(loop_.vertices[i]))) continue;
      least = angle;
      sharpest = i;
    }
    return sharpest;
  }

  /// Passes the sharpest turn on its inside. False where there is none.
  bool passSharpest() {
    const std::size_t sharpest = sharpestTurn();
    if (sharpest == passages_.size()) return false;
    pass(sharpest);
    return true;
  }

  void measure() {
    passages_.clear();
    if (isPoint(loop_)) return;
    for (std::size_t i = 0; i < loop_.vertices.size(); ++i) {
      passages_.push_back(passageAt(unfolding_, loop_, i));
    }
  }

  /// Passes a vertex on the side where the angle is less.
  void pass(std::size_t i) {
    const Passage& passage = passages_[i];
    Run way = around(unfolding_, loop_.vertices[i], passage,
                     passage.left < passage.right ? Side::Left : Side::Right);
    const std::size_t size = loop_.vertices.size();
    if (size < 3 || i == 0 || i + 1 == size) {
      std::vector<std::optional<Run>> ways(size);
      ways[i] = std::move(way);
      loop_ = pulled(unfolding_, pushedAside(unfolding_, loop_, ways), straights_);
      dropPauses(loop_);
      measure();
      return;
    }
    // Only what lies between its neighbours changes.
    Run run = std::move(loop_.runs[i - 1]);
    run.insert(run.end(), way.begin(), way.end());
    run.insert(run.end(), loop_.runs[i].begin(), loop_.runs[i].end());
    cancelReturns(unfolding_, run, false);
    std::vector<Index> vertices;
    std::vector<Run> runs;
    pull(unfolding_, vertexNode(loop_.vertices[i - 1]), std::move(run),
         vertexNode(loop_.vertices[i + 1]), vertices, runs);
    const auto at = static_cast<std::ptrdiff_t>(i);
    loop_.runs.erase(loop_.runs.begin() + at - 1, loop_.runs.begin() + at + 1);
    loop_.runs.insert(loop_.runs.begin() + at - 1, runs.begin(), runs.end());
    loop_.vertices.erase(loop_.vertices.begin() + at);
    loop_.vertices.insert(loop_.vertices.begin() + at, vertices.begin(), vertices.end());
    dropPauses(loop_);
    if (loop_.vertices.size() != size - 1 + vertices.size() || isPoint(loop_)) {
      measure();
      return;
    }
    passages_.erase(passages_.begin() + at);
    passages_.insert(passages_.begin() + at, vertices.size(), Passage{});
    for (std::size_t k = i - 1; k <= i + vertices.size(); ++k) {
      passages_[k] = passageAt(unfolding_, loop_, k);
    }
  }

  const Unfolding& unfolding_;
  TautLoop& loop_;
  Straights straights_;
  std::vector<Passage> passages_;
};

/// The first step: the shortest curve in the strips of a loose one.
void pullTight(const Unfolding& unfolding, TautLoop& loop,
               Straights straights = Straights::Pinned) {
  for (Run& run : loop.runs) cancelReturns(unfolding, run, loop.vertices.empty());
  loop = pulled(unfolding, std::move(loop), straights);
  dropPauses(loop);
}

}  // namespace

TightenedBefore::Key TightenedBefore::keyOf(const TautLoop& canonical) {
  Key key{0x9E3779B97F4A7C15u, 0xD1B54A32D192ED03u};
  const auto mixed = [](std::uint64_t value) {  // splitmix64
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
    return value ^ (value >> 31);
  };
  const auto add = [&](std::uint64_t value) {
    key.high = mixed(key.high + value);
    key.low = mixed((key.low ^ key.high) + value);
  };
  for (std::size_t i = 0; i < canonical.vertices.size(); ++i) {
    // Vertices and halfedges are told apart.
    add(std::uint64_t{canonical.vertices[i]} << 32);
    for (const Index halfedge : canonical.runs[i]) add(halfedge);
  }
  return key;
}

std::optional<TightenedBefore::Outcome> TightenedBefore::find(const Key& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = outcomes_.find(key);
  if (found == outcomes_.end()) return std::nullopt;
  return found->second;
}

void TightenedBefore::add(const std::vector<Key>& way, Outcome end) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = way.size(); i-- > 0;) {
    ++end.steps;
    outcomes_.try_emplace(way[i], end);
  }
}

Tightened tighten(const Unfolding& unfolding, TautLoop& loop) {
  pullTight(unfolding, loop);
  return Tightening(unfolding, loop).run();
}

Tightened tighten(const Unfolding& unfolding, TautLoop& loop, TightenedBefore& before) {
  pullTight(unfolding, loop);
  return Tightening(unfolding, loop).run(before);
}

Tightened tightenInPlace(const Unfolding& unfolding, TautLoop& loop,
                         const ExecutionContext& context) {
  pullTight(unfolding, loop, Straights::Float);
  return Tightening(unfolding, loop, Straights::Float).run(context);
}

TautLoop canonical(const Unfolding& unfolding, const TautLoop& loop) {
  const std::size_t size = loop.vertices.size();
  const TautLoop back = turnedRound(unfolding, loop);
  TautLoop best;
  const auto less = [](const TautLoop& a, const TautLoop& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.runs < b.runs;
  };
  const Index least = *std::min_element(loop.vertices.begin(), loop.vertices.end());
  for (const TautLoop* way : {&loop, static_cast<const TautLoop*>(&back)}) {
    for (std::size_t i = 0; i < size; ++i) {
      if (way->vertices[i] != least) continue;
      TautLoop turned = *way;
      std::rotate(turned.vertices.begin(), turned.vertices.begin() + static_cast<std::ptrdiff_t>(i),
                  turned.vertices.end());
      std::rotate(turned.runs.begin(), turned.runs.begin() + static_cast<std::ptrdiff_t>(i),
                  turned.runs.end());
      if (best.vertices.empty() || less(turned, best)) best = std::move(turned);
    }
  }
  return best;
}

double lengthOf(const Unfolding& unfolding, const TautLoop& loop) {
  double length = 0;
  if (loop.vertices.empty() && !loop.runs.empty()) {
    const auto line = floatingLine(Strip(unfolding, loop.runs[0], true));
    return line ? norm(line->second - line->first) * unfolding.unit() : 0;
  }
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    length += lengthOfRun(unfolding, vertexNode(loop.vertices[i]), loop.runs[i],
                          vertexNode(loop.vertices[(i + 1) % loop.vertices.size()]));
  }
  return length * unfolding.unit();
}

std::vector<SurfacePoint> pointsOf(const Unfolding& unfolding, const TautLoop& loop) {
  std::vector<SurfacePoint> points;
  if (loop.vertices.empty() && !loop.runs.empty()) {
    const Run& run = loop.runs[0];
    const Strip strip(unfolding, run, true);
    const auto line = floatingLine(strip);
    for (std::size_t i = 0; line && i < run.size(); ++i) {
      points.push_back(edgePoint(unfolding, run[i], strip.share(i, line->first, line->second)));
    }
  }
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    points.push_back(unfolding.toMesh(SurfacePoint::atVertex(Vertex(loop.vertices[i]))));
    appendCrossings(unfolding, vertexNode(loop.vertices[i]), loop.runs[i],
                    vertexNode(loop.vertices[(i + 1) % loop.vertices.size()]), points);
  }
  if (!points.empty()) points.push_back(points.front());
  return points;
}

namespace {

/// One step of a loop over its band to the left: from its right rim to where vertices stop it.
struct Slide {
  Run run;
  Vec2 at, along;
  double width{0};
  TautLoop end;
};

/// The behaviour of a tight loop on its left.
enum class LeftSide : std::uint8_t { Stops, Slides, Leaks };

/// Whether a tight loop can be moved to the left without getting longer, and how far; `pushed`: the
/// loop with its vertices passed on the left.
LeftSide leftOf(const Unfolding& unfolding, const TautLoop& loop, TautLoop& pushed) {
  std::vector<std::optional<Run>> ways(loop.vertices.size());
  bool isConvex = false, isStopped = false;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Passage passage = passageAt(unfolding, loop, i);
    if (passage.left > kPi + kTaut) {
      isStopped = true;
      continue;
    }
    isConvex = isConvex || passage.left < kPi - kTaut;
    ways[i] = around(unfolding, loop.vertices[i], passage, Side::Left);
  }
  if (isConvex) {
    pushed = pushedAside(unfolding, loop, ways);
    return LeftSide::Leaks;
  }
  if (isStopped) return LeftSide::Stops;
  pushed = pushedAside(unfolding, loop, ways);
  return pushed.runs[0].size() < 2 ? LeftSide::Stops : LeftSide::Slides;
}

/// The steps to the left, until something stops them; whether what stops them is a leak.
bool slideLeft(const Unfolding& unfolding, TautLoop loop, double mostWidth,
               std::vector<Slide>& slides, TautLoop& shorter) {
  double width = 0;
  for (;;) {
    TautLoop pushed;
    const LeftSide side = leftOf(unfolding, loop, pushed);
    if (side == LeftSide::Leaks) {
      shorter = std::move(pushed);
      return true;
    }
    if (side != LeftSide::Slides || width >= mostWidth) return false;
    Slide slide;
    slide.run = std::move(pushed.runs[0]);
    const Strip strip(unfolding, slide.run, true);
    // The loop is the right rim of the band: the line through the corner that it stands furthest to
    // the left of.
    Straight line = straightThrough(strip, strip.corner(strip.right(0)).place);
    double rim = 0;
    for (std::size_t i = 1; i + 1 < strip.portals(); ++i) {
      rim = std::max(rim, cross(line.along, strip.corner(strip.right(i)).place - line.at));
    }
    slide.along = line.along;
    slide.at = line.at + rim * Vec2{-line.along.y, line.along.x};
    slide.width = line.room - rim;
    const Corner& corner = strip.corner(line.corner);
    loop = pinned(unfolding, slide.run, corner.vertex, corner.lastPortal);
    slide.end = loop;
    width += slide.width;
    slides.push_back(std::move(slide));
    if (!(slides.back().width > 0)) return false;
  }
}

}  // namespace

Band bandOf(const Unfolding& unfolding, const TautLoop& loop, double area) {
  const double unit = unfolding.unit();
  const double most = area / lengthOf(unfolding, loop) / unit * (1 + kTaut);
  Band band;
  TautLoop shorter;
  std::vector<Slide> slides;
  // To the right as far as it goes; from there everything to the left.
  if (slideLeft(unfolding, turnedRound(unfolding, loop), most, slides, shorter)) {
    band.shorter = std::move(shorter);
    return band;
  }
  const TautLoop rim = slides.empty() ? loop : turnedRound(unfolding, slides.back().end);
  slides.clear();
  if (slideLeft(unfolding, rim, most, slides, shorter)) {
    band.shorter = std::move(shorter);
    return band;
  }
  double width = 0;
  for (const Slide& slide : slides) width += slide.width;
  band.width = std::min(width, most) * unit;
  for (const TautLoop* side : {&rim, slides.empty() ? &rim : &slides.back().end}) {
    for (const Index v : side->vertices) band.vertices.push_back(Vertex(unfolding.vertexInMesh(v)));
  }
  std::sort(band.vertices.begin(), band.vertices.end());
  band.vertices.erase(std::unique(band.vertices.begin(), band.vertices.end()), band.vertices.end());
  double left = width / 2;
  const TautLoop* passed = &rim;
  for (const Slide& slide : slides) {
    if (left <= kTouch * width) break;
    if (left >= slide.width) {
      left -= slide.width;
      passed = &slide.end;
      continue;
    }
    const Strip strip(unfolding, slide.run, true);
    const Vec2 at = slide.at + left * Vec2{-slide.along.y, slide.along.x};
    for (std::size_t i = 0; i < slide.run.size(); ++i) {
      band.middle.push_back(
          edgePoint(unfolding, slide.run[i], strip.share(i, at, at + slide.along)));
    }
    band.middle.push_back(band.middle.front());
    return band;
  }
  band.middle = pointsOf(unfolding, *passed);
  return band;
}

std::optional<TautLoop> neckFrom(const Unfolding& unfolding, std::span<const SurfacePoint> points,
                                 double area) {
  std::optional<TautLoop> loop = looseLoop(unfolding, points);
  double last = std::numeric_limits<double>::infinity();
  while (loop && tighten(unfolding, *loop) == Tightened::Geodesic) {
    const double length = lengthOf(unfolding, *loop);
    if (!(length < last)) break;  // rounding alone leads on
    last = length;
    Band band = bandOf(unfolding, *loop, area);
    if (!band.shorter) return canonical(unfolding, *loop);
    loop = std::move(band.shorter);
  }
  return std::nullopt;
}

}  // namespace girth::loops
