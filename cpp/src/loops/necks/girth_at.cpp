#include "loops/necks/girth_at.h"

#include <utility>

#include "girth/parallel.h"
#include "solver/solver_factory.h"

namespace girth::loops {

GirthAt::GirthAt(std::shared_ptr<const geodesic::Unfolding> unfolding,
                 const ExecutionContext& context)
    : make_([shared = std::move(unfolding)] {
        return std::make_unique<GirthSolver>(SolverFactory::onUnfolding(shared));
      }),
      context_{context.threads, context.cancel, {}} {}

Result<std::vector<GirthValue>> GirthAt::values(std::span<const SurfacePoint> points,
                                                const std::function<void(double)>& onProgress) {
  std::vector<GirthValue> values(points.size());
  const ExecutionContext context{context_.threads, context_.cancel, onProgress};
  const bool isDone = parallelFor(points.size(), 1, context, [&](std::size_t begin, std::size_t) {
    solvers_.use(make_, [&](GirthSolver& solver) {
      // Without a value: cancelled, since the points are of the surface.
      const auto value = solver.value(points[begin], context_.ofOneThread());
      if (value) values[begin] = value.value();
    });
  });
  if (!isDone || context_.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "the search was cancelled");
  }
  return values;
}

Result<std::vector<std::vector<SurfacePoint>>> GirthAt::loops(
    std::span<const SurfacePoint> points) {
  std::vector<std::vector<SurfacePoint>> loops(points.size());
  const ExecutionContext context{context_.threads, context_.cancel, {}};
  const bool isDone = parallelFor(points.size(), 1, context, [&](std::size_t begin, std::size_t) {
    solvers_.use(make_, [&](GirthSolver& solver) {
      auto loop = solver.loop(points[begin], context_.ofOneThread());
      if (loop && loop.value().kind == LoopKind::Loop) {
        loops[begin] = std::move(loop).value().points;
      }
    });
  });
  if (!isDone || context_.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "the search was cancelled");
  }
  return loops;
}

Result<std::vector<double>> GirthAt::lengths(std::span<const SurfacePoint> points) {
  const auto found = values(points);
  if (!found) return found.error();
  std::vector<double> lengths;
  lengths.reserve(points.size());
  for (const GirthValue& value : found.value()) lengths.push_back(value.length);
  return lengths;
}

}  // namespace girth::loops
