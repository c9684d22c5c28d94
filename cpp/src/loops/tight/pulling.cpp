#include "loops/tight/pulling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geodesic/tolerances.h"

namespace girth::loops {
namespace {

using geodesic::Crossing;
using geodesic::kTouch;
using Kind = SurfacePoint::Kind;

/// The edges of a vertex: those of its fan, and at a boundary one more.
std::size_t edgesOf(const Unfolding& unfolding, Index vertex) {
  return unfolding.fan(vertex).size() + (unfolding.boundary(vertex) ? 1 : 0);
}

/// Whether a node lies on an edge.
bool isOnEdge(const Unfolding& unfolding, const SurfacePoint& node, Index halfedge) {
  if (node.kind == Kind::InFace) return false;
  if (node.kind == Kind::OnEdge) {
    return node.element == halfedge || unfolding.twin(node.element) == halfedge;
  }
  const Crossing crossing = unfolding.crossing(halfedge);
  return crossing.from() == node.element || crossing.to() == node.element;
}

/// How a run that crosses nothing leaves a vertex for a point of an edge or a face.
Departure departureTowards(const Unfolding& unfolding, Index from, const SurfacePoint& to) {
  const auto fan = unfolding.fan(from);
  Departure departure;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto place = unfolding.placeIn(fan[i], to);
    if (!place) continue;
    departure.edge = i;
    departure.direction = unfolding.directionOf(fan[i], *place);
    if (to.kind != Kind::OnEdge) return departure;
    const Index twin = unfolding.twin(to.element);
    if (to.element == fan[i] || twin == fan[i]) {
      departure.alongEdge = true;
      departure.direction = unfolding.direction(fan[i]);
      return departure;
    }
    // Along the other side of the face: the next edge of the vertex, if there is none more.
    const Index side = Unfolding::previous(fan[i]);
    if (to.element != side && twin != side) return departure;
    if (unfolding.turnLeft(fan[i]) != kNoIndex) continue;
    departure.edge = fan.size();
    departure.alongEdge = true;
    departure.direction = unfolding.totalAngle(from);
    return departure;
  }
  return departure;
}

/// How the straight run from a vertex to a node leaves.
Departure departureOf(const Unfolding& unfolding, Index from, const Run& run,
                      const SurfacePoint& to) {
  const auto fan = unfolding.fan(from);
  Departure departure;
  if (run.empty()) {
    if (to.kind != Kind::AtVertex) return departureTowards(unfolding, from, to);
    departure.alongEdge = true;
    while (departure.edge < fan.size() &&
           unfolding.crossing(fan[departure.edge]).to() != to.element) {
      ++departure.edge;
    }
    departure.direction = departure.edge < fan.size() ? unfolding.direction(fan[departure.edge])
                                                      : unfolding.totalAngle(from);
    return departure;
  }
  // The run leaves through the face of its first halfedge, whose frame the strip begins in.
  const Strip strip(unfolding, run, false);
  const Index rightmost = Unfolding::previous(run[0]);
  departure.edge =
      static_cast<std::size_t>(std::find(fan.begin(), fan.end(), rightmost) - fan.begin());
  departure.direction = unfolding.directionOf(
      rightmost, unfolding.toPrevious(run[0], endIn(unfolding, strip, run, to)));
  return departure;
}

/// Takes out edges at both ends of a run on which the nodes lie that it leads from and to: they are
/// passed there.
void trim(const Unfolding& unfolding, const SurfacePoint& from, Run& run, const SurfacePoint& to) {
  std::size_t begin = 0, end = run.size();
  while (begin < end && isOnEdge(unfolding, from, run[begin])) ++begin;
  while (end > begin && isOnEdge(unfolding, to, run[end - 1])) --end;
  run = Run(run.begin() + static_cast<std::ptrdiff_t>(begin),
            run.begin() + static_cast<std::ptrdiff_t>(end));
}

/// The corners of a strip that the straight line between two points touches, in order. The line
/// crosses the portals from `first` to `last`.
void appendTouched(const Strip& strip, Vec2 a, Vec2 b, std::size_t first, std::size_t last,
                   std::vector<std::size_t>& corners) {
  for (std::size_t i = first; i < last; ++i) {
    const double share = strip.share(i, a, b);
    const bool isRight = share < kTouch;
    if (!isRight && share <= 1 - kTouch) continue;
    const std::size_t corner = isRight ? strip.right(i) : strip.left(i);
    corners.push_back(corner);
    i = std::min(last, strip.corner(corner).lastPortal);
    a = strip.corner(corner).place;
  }
}

/// The length between two nodes of one face.
double lengthInFace(const Unfolding& unfolding, const SurfacePoint& from, const SurfacePoint& to) {
  const bool isOther = from.kind == Kind::AtVertex;
  const SurfacePoint &known = isOther ? to : from, &other = isOther ? from : to;
  const Index home = unfolding.home(known);
  const Index behind = known.kind == Kind::OnEdge ? unfolding.twin(home) : kNoIndex;
  for (const Index halfedge : {home, behind}) {
    if (halfedge == kNoIndex) continue;
    const auto a = unfolding.placeIn(halfedge, known), b = unfolding.placeIn(halfedge, other);
    if (a && b) return norm(*b - *a);
  }
  return 0;
}

}  // namespace

Passage passageOf(const Unfolding& unfolding, const SurfacePoint& before, const Run& in,
                  Index vertex, const Run& out, const SurfacePoint& after) {
  Passage passage;
  passage.in = departureOf(unfolding, vertex, reversed(unfolding, in), before);
  passage.out = departureOf(unfolding, vertex, out, after);
  const double turn = passage.in.direction - passage.out.direction;
  const double total = unfolding.totalAngle(vertex);
  const double outside = unfolding.boundary(vertex) ? std::numeric_limits<double>::infinity()
                                                    : total - std::fabs(turn);
  passage.left = turn >= 0 ? turn : outside;
  passage.right = turn >= 0 ? outside : -turn;
  return passage;
}

Run around(const Unfolding& unfolding, Index vertex, const Passage& passage, Side side) {
  const auto fan = unfolding.fan(vertex);
  const std::size_t edges = edgesOf(unfolding, vertex);
  // Counter-clockwise from `a` to `b`: the edges strictly between.
  const Departure& a = side == Side::Left ? passage.out : passage.in;
  const Departure& b = side == Side::Left ? passage.in : passage.out;
  const std::size_t begin = a.edge + 1, end = b.edge + (b.alongEdge ? 0 : 1);
  std::size_t count = (end + edges - begin % edges) % edges;
  if (a.edge == b.edge && a.alongEdge == b.alongEdge) {
    // Out and in through one face or along one edge: all the way round, or not at all.
    const bool isWhole =
        side == Side::Left ? passage.left > passage.right : passage.right > passage.left;
    count = !isWhole ? 0 : a.alongEdge ? edges - 1 : edges;
  }
  Run run;
  for (std::size_t k = 0; k < count; ++k) {
    const Index halfedge = fan[(begin + k) % edges];
    run.push_back(side == Side::Left ? halfedge : unfolding.twin(halfedge));
  }
  if (side == Side::Left) std::reverse(run.begin(), run.end());
  return run;
}

void pull(const Unfolding& unfolding, const SurfacePoint& from, Run run, const SurfacePoint& to,
          std::vector<Index>& vertices, std::vector<Run>& runs) {
  trim(unfolding, from, run, to);
  if (run.empty()) {
    runs.emplace_back();
    return;
  }
  const Strip strip(unfolding, run, false);
  const Vec2 start = startIn(unfolding, strip, run, from), end = endIn(unfolding, strip, run, to);
  const std::vector<std::size_t> path = strip.bends(start, 0, end, strip.portals() - 1);
  // Vertices that are touched without a bend are passed too.
  std::vector<std::size_t> passed;
  Vec2 at = start;
  std::size_t next = 0;
  for (std::size_t i = 0; i <= path.size(); ++i) {
    const bool isLast = i == path.size();
    appendTouched(strip, at, isLast ? end : strip.corner(path[i]).place, next,
                  isLast ? strip.portals() : strip.corner(path[i]).firstPortal, passed);
    if (isLast) break;
    passed.push_back(path[i]);
    at = strip.corner(path[i]).place;
    next = strip.corner(path[i]).lastPortal + 1;
  }
  std::size_t begin = 0;
  const auto cut = [&](std::size_t behind) {
    runs.emplace_back(run.begin() + static_cast<std::ptrdiff_t>(begin),
                      run.begin() + static_cast<std::ptrdiff_t>(std::max(begin, behind)));
  };
  for (const std::size_t corner : passed) {
    cut(strip.corner(corner).firstPortal);
    vertices.push_back(strip.corner(corner).vertex);
    begin = strip.corner(corner).lastPortal + 1;
  }
  cut(run.size());
}

Vec2 startIn(const Unfolding& unfolding, const Strip& strip, const Run& run,
             const SurfacePoint& from) {
  if (from.kind == Kind::AtVertex) return strip.start();
  return unfolding.placeIn(run.front(), from).value_or(strip.start());
}

Vec2 endIn(const Unfolding& unfolding, const Strip& strip, const Run& run, const SurfacePoint& to) {
  if (to.kind == Kind::AtVertex) return strip.end();
  const Index entered = unfolding.twin(run.back());
  const auto place = unfolding.placeIn(entered, to);
  if (!place) return strip.end();
  const std::size_t last = strip.portals() - 1;
  const Vec2 left = strip.corner(strip.left(last)).place;
  const Vec2 right = strip.corner(strip.right(last)).place;
  const Vec2 along = (1 / unfolding.crossing(entered).length()) * (right - left);
  return left + geodesic::turned(*place, along);
}

double lengthOfRun(const Unfolding& unfolding, const SurfacePoint& from, const Run& run,
                   const SurfacePoint& to) {
  if (!run.empty()) {
    const Strip strip(unfolding, run, false);
    return norm(endIn(unfolding, strip, run, to) - startIn(unfolding, strip, run, from));
  }
  if (from.kind != Kind::AtVertex || to.kind != Kind::AtVertex) {
    return lengthInFace(unfolding, from, to);
  }
  for (const Index halfedge : unfolding.fan(from.element)) {
    if (unfolding.crossing(halfedge).to() == to.element) {
      return unfolding.crossing(halfedge).length();
    }
    const Index back = Unfolding::previous(halfedge);
    if (unfolding.crossing(back).from() == to.element) return unfolding.crossing(back).length();
  }
  return 0;
}

void appendCrossings(const Unfolding& unfolding, const SurfacePoint& from, const Run& run,
                     const SurfacePoint& to, std::vector<SurfacePoint>& points) {
  if (run.empty()) return;
  const Strip strip(unfolding, run, false);
  const Vec2 start = startIn(unfolding, strip, run, from), end = endIn(unfolding, strip, run, to);
  for (std::size_t k = 0; k < run.size(); ++k) {
    points.push_back(edgePoint(unfolding, run[k], strip.share(k, start, end)));
  }
}

SurfacePoint edgePoint(const Unfolding& unfolding, Index halfedge, double share) {
  return unfolding.toMesh(
      SurfacePoint::onHalfedge(Halfedge(halfedge), std::clamp(share, 0.0, 1.0)));
}

}  // namespace girth::loops
