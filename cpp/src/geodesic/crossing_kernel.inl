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
  double distanceNear;                     // of the corner at the halfedge
  double widest = length * (1 - kSliver);  // less is lost of a window that stays
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
  // Where nothing is won the quotient is negative or not a number.
  near = greater(lostNear, near);
  tip = greater(lostTip, tip);
  const Mask keep = in.crosses & less(zero, atNear.slope) & less(zero, atTip.slope) &
                    less(near + tip, all(side.widest));
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
  const Crossing& c = batch.crossing;
  const Vec2 apex = c.apex();
  const double edge = c.length();
  const SideOfFace leftSide{c.left(), c.leftLength(), batch.distanceFrom};
  const SideOfFace rightSide{c.right(), c.rightLength(), batch.distanceTo};
  const Lanes zero = {}, length = all(edge);
  Lanes leftNearest = all(kInfinity), rightNearest = leftNearest;
  unsigned towardsLeft = 0, towardsRight = 0;  // lanes in which some window went there
  std::uint32_t leftCount = 0, rightCount = 0, apexBegin = batch.count, apexEnd = 0;
  double distanceApex = batch.distanceApex;
  std::int32_t apexWindow = -1;

  std::uint32_t remaining = batch.count;
  for (const WindowRun* run = batch.newest; remaining > 0; run = run->older) {
    remaining -= run->count;
    for (std::uint32_t i = 0; i < run->count; i += kLanes) {
      const double* in = run->fields() + i;
      const std::size_t stride = run->stride;
      const Lanes x = load(in), height = -load(in + stride);
      const Lanes sigma = load(in + 2 * stride);
      const Lanes gapFrom = load(in + 3 * stride), gapTo = load(in + 4 * stride);
      // A window seen edge-on, or from above, has nothing beyond.
      const Mask valid = firstLanes(run->count - i) & less(zero, height);

      // On which side of the two bounding rays the apex lies.
      const Lanes tipX = apex.x - x, tipY = apex.y + height;
      const Lanes boundFrom = gapFrom - x, boundTo = (length - gapTo) - x;
      const Lanes leftOf = boundFrom * tipY - height * tipX;  // > 0: the apex is left of the window
      const Lanes rightOf = boundTo * tipY - height * tipX;   // < 0: right of it
      const Lanes reach = edge * (absolute(tipX) + tipY);
      const Lanes touch = kTouch * reach, snap = kSnap * reach;

      if (bits(valid & atMost(leftOf, touch) & atMost(-touch, rightOf)) != 0) {
        towardsLeft |= 1;
        towardsRight |= 1;
        const unsigned reaching = bits(valid & atMost(leftOf, snap) & atMost(-snap, rightOf));
        const Lanes distance = sigma + squareRoot(tipX * tipX + tipY * tipY);
        const std::uint32_t number = run->begin - batch.first + i;
        for (unsigned rest = reaching; rest != 0; rest &= rest - 1) {
          const unsigned lane = lowest(rest);
          const std::uint32_t window = number + lane;
          apexBegin = window < apexBegin ? window : apexBegin;
          apexEnd = window >= apexEnd ? window + 1 : apexEnd;
          if (distance[lane] < distanceApex * (1 - kRounding)) {
            distanceApex = distance[lane];
            apexWindow = (std::int32_t)window;
          }
        }
      }
      const Mask throughLeft = valid & less(leftOf, zero),
                 throughRight = valid & less(zero, rightOf);
      const unsigned lefts = bits(throughLeft), rights = bits(throughRight);
      towardsLeft |= lefts;
      towardsRight |= rights;
      if (lefts != 0 && left != nullptr) {
        pass<false>(
            {x, height, gapFrom, length - gapTo, sigma, throughLeft, atMost(-snap, rightOf)},
            leftSide, batch.distanceApex, left, leftCount, leftNearest);
      }
      if (rights != 0 && right != nullptr) {
        pass<true>({length - x, height, gapTo, length - gapFrom, sigma, throughRight,
                    atMost(leftOf, snap)},
                   rightSide, batch.distanceApex, right, rightCount, rightNearest);
      }
    }
  }
  return {leftCount,
          rightCount,
          smallest(leftNearest),
          smallest(rightNearest),
          distanceApex,
          apexWindow,
          apexBegin,
          apexEnd,
          towardsLeft != 0,
          towardsRight != 0};
}

}  // namespace girth::geodesic
