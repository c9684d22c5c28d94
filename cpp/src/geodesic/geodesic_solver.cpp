#include "girth/geodesic_solver.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "geodesic/corridor.h"
#include "geodesic/earlier_runs.h"
#include "geodesic/locate.h"
#include "geodesic/path_tracing.h"
#include "geodesic/propagation.h"
#include "geodesic/stop_at_distance.h"

namespace girth {

using geodesic::corridor;
using geodesic::Goal;
using geodesic::Keep;
using geodesic::kMostFacesKept;
using geodesic::Propagation;
using geodesic::StopAtDistance;
using geodesic::Unfolding;
using geodesic::Vec2;

struct GeodesicSolver::State {
  Unfolding unfolding;
  Propagation propagation;
  geodesic::EarlierRuns earlier;

  explicit State(const SurfaceMesh& mesh) : unfolding(mesh), propagation(unfolding) {
    propagation.allowWholeSurface();
  }

  std::optional<Error> run(std::span<const SurfacePoint> sources, Keep keep,
                           std::function<double()> limit, const ExecutionContext& context,
                           const Goal* goal = nullptr) {
    StopAtDistance stop(std::move(limit), context);
    propagation.run(sources, keep, stop, goal);
    if (stop.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    if (propagation.gaveUp()) {
      return makeError(
          ErrorCode::LimitExceeded, -1,
          "given up after " + std::to_string(propagation.windowsCrossed()) + " windows");
    }
    return std::nullopt;
  }
};

GeodesicSolver::GeodesicSolver(const SurfaceMesh& mesh) : state_(std::make_unique<State>(mesh)) {}
GeodesicSolver::~GeodesicSolver() = default;
GeodesicSolver::GeodesicSolver(GeodesicSolver&&) noexcept = default;
GeodesicSolver& GeodesicSolver::operator=(GeodesicSolver&&) noexcept = default;

Result<std::vector<double>> GeodesicSolver::distances(const SurfacePoint& source, double radius,
                                                      const ExecutionContext& context) {
  return distances(std::span(&source, 1), radius, context);
}

Result<std::vector<double>> GeodesicSolver::distances(std::span<const SurfacePoint> sources,
                                                      double radius,
                                                      const ExecutionContext& context) {
  const Unfolding& unfolding = state_->unfolding;
  if (!(radius >= 0)) {
    return makeError(ErrorCode::InvalidRadius, -1,
                     "the radius " + std::to_string(radius) + " is not a number of at least 0");
  }
  std::vector<SurfacePoint> located;
  for (const SurfacePoint& source : sources) {
    auto point = geodesic::locate(unfolding, source);
    if (!point) return point.error();
    located.push_back(point.value());
  }
  const double within = radius / unfolding.unit();
  state_->earlier = {};
  if (auto error = state_->run(
          located, Keep::Nothing, [&] { return within; }, context)) {
    return *std::move(error);
  }
  std::vector<double> result(unfolding.vertexCount(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < unfolding.vertexCount(); ++v) {
    const double distance = state_->propagation.distance(v) * unfolding.unit();
    if (distance <= radius) result[unfolding.vertexInMesh(v)] = distance;
  }
  return result;
}

Result<GeodesicPath> GeodesicSolver::path(const SurfacePoint& from, const SurfacePoint& to,
                                          const ExecutionContext& context) {
  const Unfolding& unfolding = state_->unfolding;
  const Propagation& propagation = state_->propagation;
  const auto source = geodesic::locate(unfolding, from);
  if (!source) return source.error();
  const auto target = geodesic::locate(unfolding, to);
  if (!target) return target.error();
  const Index halfedge = unfolding.home(target.value());
  const Vec2 place = *unfolding.placeIn(halfedge, target.value());

  state_->earlier = {};
  const auto known = [&] { return propagation.pathTo(halfedge, place).distance; };
  std::optional<Goal> goal;
  const auto run = [&](Keep keep) {
    return state_->run(std::span(&source.value(), 1), keep, known, context,
                       goal ? &*goal : nullptr);
  };
  if (unfolding.mesh().faceCount() > kMostFacesKept) {
    if (auto error = run(Keep::Front)) return *std::move(error);
    if (std::isinf(known())) return GeodesicPath{known(), {}};
    state_->earlier.add(propagation);
    goal = corridor(state_->propagation, source.value(), target.value(), known(), context);
    state_->earlier.add(propagation);
  }
  if (auto error = run(Keep::Everything)) return *std::move(error);
  const geodesic::PathEnd end = propagation.pathTo(halfedge, place);
  GeodesicPath path;
  path.length = end.distance * unfolding.unit();
  if (std::isinf(path.length)) return path;
  // Traced from its end, that is from `to` back to `from`.
  path.points.push_back(geodesic::endOfPath(unfolding, target.value()));
  std::vector<SurfacePoint> back;
  geodesic::tracePath(propagation, end, halfedge, place, back);
  for (const SurfacePoint& point : back) {
    if (!geodesic::samePoint(path.points.back(), point)) path.points.push_back(point);
  }
  std::reverse(path.points.begin(), path.points.end());
  for (SurfacePoint& point : path.points) point = unfolding.toMesh(point);
  return path;
}

void GeodesicSolver::setBudget(std::size_t windows) { state_->propagation.setBudget(windows); }

SearchStatistics GeodesicSolver::statistics() const {
  const Propagation& p = state_->propagation;
  return {1, p.windowsCreated() + state_->earlier.created,
          p.windowsCrossed() + state_->earlier.crossed, p.memoryBytes()};
}

}  // namespace girth
