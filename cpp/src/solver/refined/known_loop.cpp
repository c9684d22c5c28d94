#include "solver/refined/known_loop.h"

#include "mesh/vector.h"

namespace girth {

namespace {

/// Foreseen to be longer than the own loop by more than this share of the step, a loop is longer:
/// on five models of 50,000 triangles none was shorter after all.
constexpr double kLonger = 0.1;
/// Two loops are one that moves along where their lengths differ by what both foresee, but for such
/// a share of the step, and their pulls by no more than that.
constexpr double kSameDifference = 0.02, kSamePull = 0.2;

}  // namespace

Question questionAt(Index base, std::span<const KnownLoop> known, const BaseGraph& graph) {
  const KnownLoop& own = known[base];
  if (own.isProved) return Question::None;
  if (!own.isThere() || own.kind != LoopKind::Loop || own.faces.empty()) return Question::WhatIsIt;
  bool isBesideHigher = false, isBesideLower = false;
  for (const Neighbour& other : graph.neighbours(base)) {
    const KnownLoop& loop = known[other.base];
    isBesideHigher |= isContradicted(own.length, loop.length, other.distance);
    isBesideLower |=
        (loop.isProved || loop.stands) && isContradicted(loop.length, own.length, other.distance);
  }
  if ((isBesideHigher || own.isDoubted) && !own.stands) return Question::DoesItStand;
  return isBesideLower ? Question::WhatIsIt : Question::None;
}

Vec3 pullOf(const SurfaceMesh& mesh, const GirthLoop& loop) {
  if (loop.points.size() < 3) return {kNoValue, kNoValue, kNoValue};
  const Vec3 base = positionOf(mesh, loop.base);
  const auto towards = [&](const SurfacePoint& point) {
    const Vec3 way = positionOf(mesh, point) - base;
    return 1 / norm(way) * way;
  };
  return towards(loop.points[1]) + towards(loop.points[loop.points.size() - 2]);
}

bool isNoGain(const KnownLoop& own, const KnownLoop& neighbours, const Vec3& step) {
  const double way = norm(step), difference = neighbours.length - own.length;
  const double gain = dot(neighbours.pull, step), gainFromOwn = dot(own.pull, step);
  if (difference - gain > kLonger * way) return true;
  return std::fabs(difference - (gain + gainFromOwn) / 2) < kSameDifference * way &&
         norm(neighbours.pull - own.pull) < kSamePull;
}

}  // namespace girth
