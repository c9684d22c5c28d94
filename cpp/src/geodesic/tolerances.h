// Every tolerance of the geodesic code, in one place, each free of scale and each with its reason.
//
// On regular shapes with rounded coordinates thousands of paths tie, and vertices are flat to the
// last digit that was kept. There the order of these numbers decides whether the girth is right:
//
// | no larger than             | since otherwise                                                  |
// | -------------------------- | ---------------------------------------------------------------- |
// | kSliver ≤ kSnap ≤ kAim     | a line could pass between two windows that end at one vertex     |
// | kSaddleAngle = kFlatAngle  | a vertex could be neither passed nor bent round                  |
// | 4 kAim ≤ kShunned          | a line through a convex vertex could be a loop                   |
// | kStraight ≤ kFanOverlap    | a path could go on straight where no window was sent             |
// | kFanOverlap, kAim ≤        | the midpoint of a loop, which lies as much beside its place as   |
// |   kShortest ≤ kTie         | the loop is bent or beside its windows, could be nearer over a   |
// |                            | third path by more than a tie, or not nearer where it is         |
// | kRounding < kShortest      | a path that is not the shortest could prove a loop               |
// | kTouch ≪ kTaut           | a curve drawn through a vertex that it touches would be bent      |
// |                            | there, pushed off it, and touch it again                         |
// | √kRounding ≪ kBeside       | of paths that tie, the direction of one could be forgotten: two  |
// |                            | that arrive ε apart differ in length by ε²/2 of it               |
#pragma once

namespace girth::geodesic {

/// Two paths to one point tie when their lengths differ by less than this share. Rounding alone
/// gives about 1e-15 times the number of faces crossed.
inline constexpr double kTie = 1e-11;

/// The halves of a loop are shortest paths if no path to its midpoint is shorter by more than this
/// share. Hardly more than rounding: three paths that nearly tie are usual on regular shapes.
inline constexpr double kShortest = 1e-12;

/// Lengths that differ by less than this share differ by rounding. A vertex does not become nearer
/// by less: of two paths that tie the one found first stays, and what was concluded from it.
inline constexpr double kRounding = 1e-14;

/// Directions at a root are known to this, in radians: a line that misses the end of a window by
/// less passes it. Neighbouring windows that end at one vertex are so never separated by a crack.
inline constexpr double kAim = 1e-12;

/// The midpoint of a loop that lies nearer to a convex vertex than this share of the loop's length
/// may lie on its other side: a line can miss the end of a window by kAim, and the window of the
/// other half another one.
inline constexpr double kShunned = 4e-12;

/// A point beside an edge, or along it beside its end, by less than this share of the edge lies on
/// it, or at the end.
inline constexpr double kTouch = 1e-10;

/// A bounding ray that passes a vertex within this share of the edge passes through it. Far tighter
/// than kTouch, since the error grows with the distance that the window still travels.
inline constexpr double kSnap = 1e-12;

/// A window narrower than this share of its edge is a product of rounding and dropped: what it
/// would have covered lies within kAim of its neighbour.
inline constexpr double kSliver = 1e-13;

/// Margin of trimming, as a share of the squared distance: a window keeps what is worse than a path
/// along the edge by less than rounding could explain.
inline constexpr double kTrim = 2e-13;

/// A vertex can lie on a geodesic if its total angle is at least 2π less this.
inline constexpr double kFlatAngle = 1e-12;

/// A vertex is a source of new windows (a saddle) if its total angle exceeds 2π by more than this.
inline constexpr double kSaddleAngle = 1e-12;

/// A fan of a saddle is widened by this, so that it overlaps the windows beside it. A path bent by
/// ε is longer than a straight one by ε²/2 of its length: nothing, in doubles.
inline constexpr double kFanOverlap = 1e-12;

/// Paths that tie at a vertex come in beside one another by less than this: what comes in farther
/// away is another path, and goes on elsewhere.
inline constexpr double kBeside = 1e-5;

/// Two ends of a path are straight at a vertex if both sides leave π less this; the error is its
/// square.
inline constexpr double kStraight = 1e-12;

/// A closed curve is tight where both sides of each vertex that it passes leave π less this: it is
/// longer than the shortest by half the square of that, as a share.
inline constexpr double kTaut = 1e-8;

static_assert(kSliver <= kSnap && kSnap <= kAim && kSaddleAngle == kFlatAngle &&
              kStraight <= kFanOverlap && kFanOverlap <= kShortest && kAim <= kShortest &&
              kShortest <= kTie && kRounding < kShortest && 100 * kRounding < kBeside * kBeside &&
              50 * kTouch <= kTaut && 4 * kAim <= kShunned);

}  // namespace girth::geodesic
