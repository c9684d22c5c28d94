// The kernel itself; compiled once for each instruction set, in files that name it
// GIRTH_CROSSING_KERNEL.

#include "geodesic/crossing_kernel.h"
#include "geodesic/lanes.h"
#include "geodesic/trimming.h"

namespace girth::geodesic {
namespace {

constexpr double kInfinity = __builtin_inf();

/// One side of the face, as the left one; the right one comes mirrored.
struct SideOfFace {
  Vec2 direction;
  double length;
  double distanceNear;  // of the corner at the halfedge
};

/// What goes through one side, seen from that side's corner at the halfedge.
struct Passing {
  Lanes root, height;       // the root: (root, −height)
  Lanes gapNear, boundFar;  // where the two bounding rays pass the halfedge, from that corner
  Lanes sigma;
  Mask crosses;  // the window reaches the side
  Mask toApex;   // and all of it up to the apex
};

/// Writes the windows that continue through a side, less what its two ends make useless.
/// `mirrored`: the right side.
template <bool mirrored>
inline void pass(const Passing& in, const SideOfFace& side, double distanceApex, WindowRun* exit,
                 std::uint32_t& count, Lanes& nearest) {
  const Lanes length = all(side.length), zero = {};
  const Lanes ux = all(side.direction.x), uy = all(side.direction.y);
  const Pair<Lanes> root = rootBeyond(in.root, -in.height, ux, uy);
  Lanes near = gapBeyond(in.gapNear, in.root, in.height, ux, uy);
  Lanes tip = length - gapBeyond(in.boundFar, in.root, in.height, ux, uy);
  tip = select(in.toApex, zero, greater(tip, zero));

  const Lanes leadNear = side.distanceNear - in.sigma, leadTip = distanceApex - in.sigma;
  const Contest<Lanes> atNear = contest(root.x, root.y, leadNear);
  const Contest<Lanes> atTip = contest(length - root.x, root.y, leadTip);
  const Lanes lostNear = atNear.excess / atNear.slope, lostTip = atTip.excess / atTip.slope;
  // Where nothing is won the quotient is negative or not a number, and the comparison false.
  near = select((lostNear > near) & (atNear.slope > zero), lostNear, near);
  tip = select((lostTip > tip) & (atTip.slope > zero), lostTip, tip);
  Mask keep = in.crosses & (near + tip < length * (1 - kSliver));
  keep &= (atNear.slope > zero) | ((leadNear > zero) & (atNear.excess <= zero));
  keep &= (atTip.slope > zero) | ((leadTip > zero) & (atTip.excess <= zero));
  const unsigned kept = bits(keep);
  if (kept == 0) return;

  // The nearest point: the foot of the root's perpendicular, or the end of the interval next to it.
  const Lanes aside = smaller(greater(root.x, near), length - tip) - root.x;
  const Lanes distance = in.sigma + squareRoot(aside * aside + root.y * root.y);
  nearest = smaller(select(keep, distance, nearest), nearest);

  double* out = exit->fields() + count;
  const std::size_t stride = exit->stride;
  store(out, pack(mirrored ? length - root.x : root.x, kept));
  store(out + stride, pack(root.y, kept));
  store(out + 2 * stride, pack(in.sigma, kept));
  store(out + 3 * stride, pack(mirrored ? tip : near, kept));
  store(out + 4 * stride, pack(mirrored ? near : tip, kept));
  count += (unsigned)__builtin_popcount(kept);
}

}  // namespace

CrossingResult GIRTH_CROSSING_KERNEL(const CrossingBatch& batch, WindowRun* left,
                                     WindowRun* right) {
  static_assert(kLanes <= WindowRun::kMostLanes);
  const Crossing& c = *batch.crossing;
  CrossingResult result{0, 0, kInfinity, kInfinity, batch.distanceApex, -1, 0, 0, false, false};
  const SideOfFace leftSide{c.left, c.leftLength, batch.distanceFrom};
  const SideOfFace rightSide{c.right, c.rightLength, batch.distanceTo};
  const Lanes zero = {}, length = all(c.length);
  Lanes leftNearest = all(kInfinity), rightNearest = leftNearest;
  Mask towardsLeft = {}, towardsRight = {};

  const WindowRun* run = batch.newest;
  std::uint32_t i = 0;
  for (std::uint32_t remaining = batch.count; remaining > 0;) {
    const double* in = run->fields() + i;
    const std::size_t stride = run->stride;
    const std::uint32_t number = run->begin - batch.first + i, inRun = run->count - i;
    const Lanes x = load(in), height = -load(in + stride);
    const Lanes sigma = load(in + 2 * stride);
    const Lanes gapFrom = load(in + 3 * stride), gapTo = load(in + 4 * stride);
    // A window seen edge-on, or from above, has nothing beyond.
    const Mask valid = firstLanes(inRun) & (height > zero);
    if (inRun > kLanes) {
      i += kLanes;
      remaining -= kLanes;
    } else {
      i = 0;
      remaining -= inRun;
      run = run->older;
    }

    // On which side of the two bounding rays the apex lies.
    const Lanes tipX = c.apex.x - x, tipY = c.apex.y + height;
    const Lanes boundFrom = gapFrom - x, boundTo = (length - gapTo) - x;
    const Lanes leftOf = boundFrom * tipY - height * tipX;  // > 0: the apex lies left of the window
    const Lanes rightOf = boundTo * tipY - height * tipX;   // < 0: right of it
    const Lanes reach = c.length * (absolute(tipX) + tipY);
    const Lanes snap = kSnap * reach, touch = kTouch * reach;
    const Mask notLeft = leftOf <= snap, notRight = rightOf >= -snap;
    const Mask ofApex = valid & notLeft & notRight;

    if (const unsigned reaching = bits(ofApex); reaching != 0) {
      const Lanes distance = sigma + squareRoot(tipX * tipX + tipY * tipY);
      for (int lane = 0; lane < kLanes; ++lane) {
        if ((reaching >> lane & 1) == 0) continue;
        const std::uint32_t window = number + (std::uint32_t)lane;
        if (window < result.apexBegin || result.apexEnd == 0) result.apexBegin = window;
        if (window >= result.apexEnd) result.apexEnd = window + 1;
        if (distance[lane] < result.distanceApex * (1 - kRounding)) {
          result.distanceApex = distance[lane];
          result.apexWindow = (std::int32_t)window;
        }
      }
    }
    const Mask throughLeft = valid & (leftOf < zero), throughRight = valid & (rightOf > zero);
    towardsLeft |= valid & (leftOf <= touch);
    towardsRight |= valid & (rightOf >= -touch);
    if (left != nullptr && bits(throughLeft) != 0) {
      pass<false>({x, height, gapFrom, length - gapTo, sigma, throughLeft, notRight}, leftSide,
                  batch.distanceApex, left, result.leftCount, leftNearest);
    }
    if (right != nullptr && bits(throughRight) != 0) {
      pass<true>({length - x, height, gapTo, length - gapFrom, sigma, throughRight, notLeft},
                 rightSide, batch.distanceApex, right, result.rightCount, rightNearest);
    }
  }
  result.leftNearest = smallest(leftNearest);
  result.rightNearest = smallest(rightNearest);
  result.towardsLeft = bits(towardsLeft) != 0;
  result.towardsRight = bits(towardsRight) != 0;
  return result;
}

}  // namespace girth::geodesic
