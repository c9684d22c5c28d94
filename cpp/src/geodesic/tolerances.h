// Every tolerance of the geodesic code, in one place, each free of scale and each with its reason.
#pragma once

namespace girth::geodesic {

/// Two paths to one point tie when their lengths differ by less than this share. Rounding alone
/// gives about 1e-15 times the number of faces crossed.
inline constexpr double kTie = 1e-11;

/// A vertex does not become nearer by less than this share, so that of two paths that tie the one
/// found first stays, and what was concluded from it.
inline constexpr double kRounding = 1e-13;

/// A line that misses the end of a window, or a vertex, by less than this share of the edge still
/// counts as meeting it. Neighbouring windows that end at one vertex are so never separated by a
/// crack.
inline constexpr double kTouch = 1e-10;

/// A bounding ray that passes a vertex within this share of the edge passes through it. Far tighter
/// than kTouch, since the error grows with the distance that the window still travels.
inline constexpr double kSnap = 1e-12;

/// A window narrower than this share of its edge is a product of rounding and dropped: what it
/// would have covered lies within kTouch of its neighbour.
inline constexpr double kSliver = 1e-13;

/// Margin of trimming, as a share of the squared distance: a window keeps what is worse than a path
/// along the edge by less than rounding could explain.
inline constexpr double kTrim = 2e-13;

/// A vertex can lie on a geodesic if its total angle is at least 2π less this.
inline constexpr double kFlatAngle = 1e-9;

/// A vertex is a source of new windows (a saddle) if its total angle exceeds 2π by more than this.
inline constexpr double kSaddleAngle = 1e-12;

/// A fan of a saddle is widened by this, so that it overlaps the windows beside it. A path bent by
/// ε is longer than a straight one by ε²/2 of its length: nothing, in doubles.
inline constexpr double kFanOverlap = 1e-10;

/// Two ends of a path are straight at a vertex if both sides leave π less this; the error is its
/// square.
inline constexpr double kStraight = 1e-8;

}  // namespace girth::geodesic
