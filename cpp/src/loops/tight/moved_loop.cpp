#include "loops/tight/moved_loop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "infinity.h"
#include "loops/cut/faces_of_points.h"

namespace girth::loops {
namespace {

/// Nearer to a portal than this share of it: on it.
constexpr double kOnPortal = 1e-9;

bool liesOn(const Strip& strip, std::size_t portal, Vec2 place) {
  const Vec2 right = strip.corner(strip.right(portal)).place;
  const Vec2 along = strip.corner(strip.left(portal)).place - right;
  const double size = dot(along, along), off = std::fabs(cross(along, place - right));
  const double share = dot(along, place - right);
  return off <= kOnPortal * size && share >= -kOnPortal * size && share <= (1 + kOnPortal) * size;
}

/// The length of the shortest path from in front of the first portal to behind the last one.
double lengthWithin(const Strip& strip, Vec2 start, Vec2 end) {
  // Portals that an end of the path lies on are no bounds to it.
  std::size_t first = 0, behind = strip.portals();
  while (first < behind && liesOn(strip, first, start)) ++first;
  while (first < behind && liesOn(strip, behind - 1, end)) --behind;
  double length = 0;
  if (first < behind) {
    for (const std::size_t corner : strip.bends(start, first, end, behind - 1)) {
      const Vec2 place = strip.corner(corner).place;
      length += norm(place - start);
      start = place;
    }
  }
  return length + norm(end - start);
}

}  // namespace

MovedLoop::MovedLoop(const Unfolding& unfolding, std::span<const SurfacePoint> points)
    : unfolding_(&unfolding) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points_.push_back(unfolding.fromMesh(points[i]));
    if (i == 0) continue;
    const auto common = commonFace(unfolding.mesh(), points[i - 1], points[i]);
    if (!common) {
      points_.clear();
      return;
    }
    faces_.push_back(unfolding.fromMesh(SurfacePoint::inFace(common->face, {})).element);
  }
}

Index MovedLoop::outOf(Index vertex, Index face) const {
  Index side = 3 * face;
  while (side < 3 * face + 2 && unfolding_->crossing(side).from() != vertex) ++side;
  return side;
}

bool MovedLoop::turn(Index vertex, Index from, Index to, bool isLeft, Run& run) const {
  for (Index side = outOf(vertex, from); faceOfSide(side) != to;) {
    run.push_back(isLeft ? Unfolding::previous(side) : side);
    side = isLeft ? unfolding_->turnLeft(side) : unfolding_->turnRight(side);
    if (side == kNoIndex) return false;
  }
  return true;
}

bool MovedLoop::pass(const SurfacePoint& point, Index from, Index to, Side side, Run& run) const {
  if (from == to) return true;
  if (point.kind == SurfacePoint::Kind::AtVertex) {
    // With the vertex on the other side.
    return turn(point.element, from, to, side == Side::Right, run);
  }
  const Index twin = unfolding_->twin(point.element);
  const bool isFromHere = faceOfSide(point.element) == from;
  run.push_back(isFromHere ? point.element : twin);
  return faceOfSide(isFromHere ? twin : point.element) == to;
}

std::optional<std::pair<Run, Run>> MovedLoop::ends(Index face) const {
  std::optional<std::pair<Run, Run>> best;
  for (const Side side : {Side::Left, Side::Right}) {
    std::pair<Run, Run> runs;
    if (!pass(points_[0], face, faces_.front(), side, runs.first) ||
        !pass(points_[0], faces_.back(), face, side, runs.second)) {
      continue;
    }
    const auto size = [](const std::pair<Run, Run>& of) {
      return of.first.size() + of.second.size();
    };
    if (!best || size(runs) < size(*best)) best = std::move(runs);
  }
  return best;
}

double MovedLoop::lengthAt(Face face, const SurfacePoint& point) const {
  return std::min(lengthTowards(face, point, 1, Side::Left),
                  lengthTowards(face, point, 1, Side::Right));
}

double MovedLoop::lengthTowards(Face meshFace, const SurfacePoint& meshPoint, double share,
                                Side side) const {
  if (faces_.size() < 2) return kInfinity;
  const Index face = unfolding_->fromMesh(SurfacePoint::inFace(meshFace, {})).element;
  const SurfacePoint point = unfolding_->fromMesh(meshPoint);
  const SurfacePoint& base = points_[0];
  if (!unfolding_->placeIn(3 * face, base) || !unfolding_->placeIn(3 * face, point))
    return kInfinity;
  const auto atBase = ends(face);
  if (!atBase) return kInfinity;
  Run run = atBase->first;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    if (!pass(points_[i], faces_[i - 1], faces_[i], side, run)) return kInfinity;
  }
  run.insert(run.end(), atBase->second.begin(), atBase->second.end());
  cancelReturns(*unfolding_, run, false);
  if (run.empty()) return kInfinity;
  const Strip strip(*unfolding_, run, false);
  const auto placeIn = [&](Index halfedge) {
    const Vec2 from = *unfolding_->placeIn(halfedge, base);
    return from + share * (*unfolding_->placeIn(halfedge, point) - from);
  };
  // The face behind the last edge is the same one.
  const Index entered = unfolding_->twin(run.back());
  const std::size_t portal = strip.portals() - 1;
  const Vec2 left = strip.corner(strip.left(portal)).place;
  const Vec2 right = strip.corner(strip.right(portal)).place;
  const Vec2 along = (1 / unfolding_->crossing(entered).length()) * (right - left);
  const Vec2 end = left + geodesic::turned(placeIn(entered), along);
  return lengthWithin(strip, placeIn(run.front()), end) * unfolding_->unit();
}

}  // namespace girth::loops
