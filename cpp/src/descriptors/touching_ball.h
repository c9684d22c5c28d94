// The smallest ball that touches one triangle and reaches another.
//
// A ball that touches a plane at p, on the side of the unit vector `inward`, and passes through q
// has the diameter |q − p|² / ((q − p) · inward). For q in front of the plane this is a convex
// function of q − p, quadratic over linear; so over a triangle, or over two, its least value is
// found among few candidates, by + − × ÷ √ alone.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "girth/elements.h"
#include "mesh/vector.h"

namespace girth {

/// A ball that touches the surface at `from` and reaches it at `to`.
struct TouchingBall {
  double diameter{std::numeric_limits<double>::infinity()};
  Vec3 from, to;
  Face across{Face::none};  ///< the face that it reaches; none until a surface says so
};

/// A flat convex piece of the surface that balls are to reach: a triangle, a segment or a point.
struct Target {
  std::array<Vec3, 3> corners;
  std::size_t count{3};  ///< the number of its corners
  /// The unit normal of a triangle, away from where balls come from.
  Vec3 normal;
};

/// The smallest ball at p that reaches a target; infinite where none does. Only balls that come
/// from behind a triangle's normal count.
TouchingBall ballAt(const Vec3& p, const Vec3& inward, const Target& target);

/// A flat convex piece of the surface on which balls are to touch.
struct Base {
  /// Counter-clockwise or clockwise; 3 or 4 of them.
  std::array<Vec3, 4> corners;
  std::size_t count{3};
  /// Whether the surface's normal at the rim is that of the plane: it is flat there, or ends, or
  /// has a crease. Where it bends a little, balls at the rim would lean; then only those count that
  /// reach the target straight ahead.
  bool exact{true};
  Vec3 inward;
};

/// The smallest ball that touches a base anywhere, and reaches a target.
TouchingBall ballBetween(const Base& base, const Target& target);

}  // namespace girth
