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
inline void pass(const Passing& in, const SideOfFace& side, double distanceApex, CrossingExit exit,
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

  double* out = exit.windows + count;
  store(out, pack(mirrored ? length - root.x : root.x, kept));
  store(out + exit.stride, pack(root.y, kept));
  store(out + 2 * exit.stride, pack(in.sigma, kept));
  store(out + 3 * exit.stride, pack(mirrored ? tip : near, kept));
  store(out + 4 * exit.stride, pack(mirrored ? near : tip, kept));
  count += (unsigned)__builtin_popcount(kept);
}

}  // namespace

CrossingResult GIRTH_CROSSING_KERNEL(const CrossingBatch& batch, CrossingExit left,
                                     CrossingExit right) {
  const Crossing& c = *batch.crossing;
  CrossingResult result{0, 0, kInfinity, kInfinity, batch.distanceApex, -1, 0, 0, false, false};
  const SideOfFace leftSide{c.left, c.leftLength, batch.distanceFrom};
  const SideOfFace rightSide{c.right, c.rightLength, batch.distanceTo};
  const Lanes zero = {}, length = all(c.length);
  Lanes leftNearest = all(kInfinity), rightNearest = leftNearest;
  Mask towardsLeft = {}, towardsRight = {};

  for (std::uint32_t first = 0; first < batch.count; first += kLanes) {
    const double* in = batch.windows + first;
    const Lanes x = load(in), height = -load(in + batch.stride);
    const Lanes sigma = load(in + 2 * batch.stride);
    const Lanes gapFrom = load(in + 3 * batch.stride), gapTo = load(in + 4 * batch.stride);
    // A window seen edge-on, or from above, has nothing beyond.
    const Mask valid = firstLanes(batch.count - first) & (height > zero);

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
      for (int i = 0; i < kLanes; ++i) {
        if ((reaching >> i & 1) == 0) continue;
        const std::uint32_t number = first + (std::uint32_t)i;
        if (result.apexEnd == 0) result.apexBegin = number;
        result.apexEnd = number + 1;
        if (distance[i] < result.distanceApex * (1 - kRounding)) {
          result.distanceApex = distance[i];
          result.apexWindow = (std::int32_t)number;
        }
      }
    }
    const Mask throughLeft = valid & (leftOf < zero), throughRight = valid & (rightOf > zero);
    towardsLeft |= valid & (leftOf <= touch);
    towardsRight |= valid & (rightOf >= -touch);
    if (left.windows != nullptr && bits(throughLeft) != 0) {
      pass<false>({x, height, gapFrom, length - gapTo, sigma, throughLeft, notRight}, leftSide,
                  batch.distanceApex, left, result.leftCount, leftNearest);
    }
    if (right.windows != nullptr && bits(throughRight) != 0) {
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
