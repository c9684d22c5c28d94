#include "solver/search/loop_check.h"

#include <algorithm>
#include <span>

#include "geodesic/goal.h"
#include "geodesic/stop_at_distance.h"

namespace girth {

using geodesic::Unfolding;

namespace {

/// Ways that are shorter by no more than this share are as long.
constexpr double kSameWay = 1e-9;
/// Mean edge lengths that are searched beyond the midpoint of a loop that does not stand: so far
/// away are the midpoints of other loops that it may refute.
constexpr double kBeyond = 3;

}  // namespace

std::optional<bool> LoopCheck::stands(const SurfacePoint& base, double length,
                                      const SurfacePoint& middle, const ExecutionContext& context) {
  const Unfolding& unfolding = propagation_->unfolding();
  const double unit = unfolding.unit(), half = length / 2 / unit;
  const geodesic::Goal goal(unfolding, positionOf(unfolding.mesh(), middle), half);
  const SurfacePoint source = unfolding.fromMesh(base);
  const double beyond = kBeyond * unfolding.mesh().meanEdgeLength() / unit;
  geodesic::StopAtDistance stop([&] { return std::min(half, wayTo(middle) / unit + beyond); },
                                context);
  propagation_->run(std::span(&source, 1), geodesic::Keep::Everything, stop, &goal);
  if (stop.cancelled() || propagation_->gaveUp()) return std::nullopt;
  return !(wayTo(middle) < length / 2 * (1 - kSameWay));
}

bool LoopCheck::refutes(double away, double length, const SurfacePoint& middle) const {
  return away + wayTo(middle) < length / 2 * (1 - kSameWay);
}

/// The shortest way to a point that is known so far; infinite: none is.
double LoopCheck::wayTo(const SurfacePoint& point) const {
  const Unfolding& unfolding = propagation_->unfolding();
  const SurfacePoint there = unfolding.fromMesh(point);
  const Index halfedge = unfolding.home(there);
  return propagation_->pathTo(halfedge, *unfolding.placeIn(halfedge, there)).distance *
         unfolding.unit();
}

}  // namespace girth
