#include "descriptors/touching_ball.h"

#include <algorithm>
#include <cmath>

#include "mesh/nearest_point.h"

namespace girth {

namespace {

constexpr double kNoBall = std::numeric_limits<double>::infinity();

/// Where on a segment, in [0, 1], the ball that touches at the origin is smallest; and its
/// diameter.
struct OnSegment {
  double share, diameter;
};

/// The segment starts at `start` and runs along `run`. With a = start · inward and b = run · inward
/// the derivative of |start + t run|² / (a + t b) vanishes where a + t b = |a run − b start| /
/// |run|.
OnSegment ballToSegment(const Vec3& start, const Vec3& run, const Vec3& inward) {
  const double a = dot(start, inward), b = dot(run, inward), squared = dot(run, run);
  const Vec3 turned = a * run - b * start;
  const double least = std::sqrt(squared) * norm(turned);  // a + t b there, times `squared`
  double share = 0;
  if (a >= 0) {
    const double divisor = least + squared * a;
    share = divisor > 0 ? (b * dot(start, start) - 2 * a * dot(start, run)) / divisor : 0;
  } else if (b > 0) {
    share = (least - squared * a) / (squared * b);
  }
  share = std::clamp(share, 0.0, 1.0);
  const Vec3 to = start + share * run;
  const double depth = a + share * b, distance = dot(to, to);
  if (depth > 0) return {share, distance / depth};
  // The origin lies on the segment, which goes on in front of the plane: smaller and smaller balls.
  const bool goesOn = std::max(a, a + b) > 0;
  return {share, goesOn && distance <= 1e-30 * squared ? 0 : kNoBall};
}

void take(TouchingBall& best, double diameter, const Vec3& from, const Vec3& to) {
  if (diameter < best.diameter) best = {diameter, from, to};
}

bool contains(const Target& triangle, const Vec3& q) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = triangle.corners[k];
    if (dot(cross(triangle.corners[(k + 1) % 3] - corner, q - corner), triangle.normal) < 0) {
      return false;
    }
  }
  return true;
}

/// How many edges a target has.
std::size_t edgesOf(const Target& target) { return target.count == 3 ? 3 : target.count - 1; }

/// The point of the base nearest to another of its plane.
Vec3 nearestInBase(const Vec3& p, const Base& base) {
  const auto& c = base.corners;
  Vec3 nearest = nearestInTriangle(p, {c[0], c[1], c[2]}).position;
  if (base.count == 4) {
    const Vec3 other = nearestInTriangle(p, {c[0], c[2], c[3]}).position;
    const Vec3 d = nearest - p, e = other - p;
    if (dot(e, e) < dot(d, d)) nearest = other;
  }
  return nearest;
}

/// Balls at the corners of the base.
void tryCorners(const Base& base, const Target& target, TouchingBall& best) {
  for (std::size_t i = 0; i < base.count; ++i) {
    const Vec3& p = base.corners[i];
    if (base.exact) {
      const TouchingBall ball = ballAt(p, base.inward, target);
      take(best, ball.diameter, p, ball.to);
      continue;
    }
    // Straight ahead only.
    const double slope = dot(target.normal, base.inward);
    if (target.count < 3 || !(slope > 0)) continue;
    const double distance = dot(target.corners[0] - p, target.normal) / slope;
    const Vec3 q = p + distance * base.inward;
    if (distance >= 0 && contains(target, q)) take(best, distance, p, q);
  }
}

/// Balls that reach the corners of the target.
void tryTargetCorners(const Base& base, const Target& target, TouchingBall& best) {
  for (std::size_t i = 0; i < target.count; ++i) {
    const Vec3& q = target.corners[i];
    const double depth = dot(q - base.corners[0], base.inward);
    if (!(depth > 0)) continue;
    const Vec3 foot = q - depth * base.inward, p = nearestInBase(foot, base);
    const Vec3 aside = p - foot;
    const double off = dot(aside, aside);
    if (!base.exact && off > 1e-12 * depth * depth) continue;
    take(best, depth + off / depth, p, q);
  }
}

/// Balls between an edge of the base and one of the target.
void tryEdges(const Base& base, const Target& target, TouchingBall& best) {
  for (std::size_t i = 0; i < base.count; ++i) {
    const Vec3& corner = base.corners[i];
    const Vec3 side = base.corners[(i + 1) % base.count] - corner;
    const double squared = dot(side, side);
    if (!(squared > 0)) continue;
    for (std::size_t k = 0; k < edgesOf(target); ++k) {
      const Vec3 start = target.corners[k] - corner;
      const Vec3 run = target.corners[(k + 1) % target.count] - target.corners[k];
      // Without what lies along the side, for the best point of the side is abreast.
      const Vec3 across = start - (dot(start, side) / squared) * side;
      const Vec3 acrossRun = run - (dot(run, side) / squared) * side;
      double share = 0, diameter = kNoBall;
      if (base.exact) {
        const OnSegment found = ballToSegment(across, acrossRun, base.inward);
        share = found.share;
        diameter = found.diameter;
      } else {
        // Straight ahead only: where the two cross, seen along `inward`.
        const Vec3 aside = across - dot(across, base.inward) * base.inward;
        const Vec3 asideRun = acrossRun - dot(acrossRun, base.inward) * base.inward;
        const double length = dot(asideRun, asideRun);
        if (!(length > 1e-20 * dot(run, run))) continue;  // parallel: their ends do
        share = -dot(aside, asideRun) / length;
        if (!(share >= 0 && share <= 1)) continue;
        diameter = dot(start + share * run, base.inward);
        if (!(diameter > 0)) continue;
      }
      const Vec3 to = start + share * run;
      const double along = dot(to, side) / squared;
      if (along >= 0 && along <= 1) take(best, diameter, corner + along * side, corner + to);
    }
  }
}

}  // namespace

TouchingBall ballAt(const Vec3& p, const Vec3& inward, const Target& target) {
  TouchingBall best;
  if (target.count == 1) {
    const Vec3 d = target.corners[0] - p;
    const double depth = dot(d, inward);
    if (depth > 0) take(best, dot(d, d) / depth, p, target.corners[0]);
    return best;
  }
  if (target.count == 3) {
    const double distance = dot(target.corners[0] - p, target.normal);
    if (distance < 0) return best;
    const double radius = distance / (1 + dot(target.normal, inward));
    const Vec3 q = p + radius * (inward + target.normal);
    if (contains(target, q)) return {2 * radius, p, q};
  }
  for (std::size_t k = 0; k < edgesOf(target); ++k) {
    const Vec3 start = target.corners[k] - p;
    const Vec3 run = target.corners[(k + 1) % target.count] - target.corners[k];
    const OnSegment found = ballToSegment(start, run, inward);
    take(best, found.diameter, p, target.corners[k] + found.share * run);
  }
  return best;
}

TouchingBall ballBetween(const Base& base, const Target& target) {
  TouchingBall best;
  tryCorners(base, target, best);
  tryTargetCorners(base, target, best);
  tryEdges(base, target, best);
  return best;
}

}  // namespace girth
