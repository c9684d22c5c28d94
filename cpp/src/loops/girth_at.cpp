#include "loops/girth_at.h"

#include <utility>

#include "girth/parallel.h"
#include "girth/solver_factory.h"

namespace girth::loops {

GirthAt::GirthAt(std::shared_ptr<const geodesic::Unfolding> unfolding,
                 const ExecutionContext& context)
    : unfolding_(std::move(unfolding)), context_{context.threads, context.cancel, {}} {}

Result<std::vector<GirthValue>> GirthAt::values(std::span<const SurfacePoint> points,
                                                const std::function<void(double)>& onProgress) {
  std::vector<GirthValue> values(points.size());
  const ExecutionContext context{context_.threads, context_.cancel, onProgress};
  const bool isDone = parallelFor(points.size(), 1, context, [&](std::size_t begin, std::size_t) {
    std::unique_ptr<GirthSolver> solver = taken();
    // Without a value: cancelled, since the points are of the surface.
    const auto value = solver->value(points[begin], context_.ofOneThread());
    if (value) values[begin] = value.value();
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(solver));
  });
  if (!isDone || context_.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "the search was cancelled");
  }
  return values;
}

Result<std::vector<double>> GirthAt::lengths(std::span<const SurfacePoint> points) {
  const auto found = values(points);
  if (!found) return found.error();
  std::vector<double> lengths;
  lengths.reserve(points.size());
  for (const GirthValue& value : found.value()) lengths.push_back(value.length);
  return lengths;
}

std::unique_ptr<GirthSolver> GirthAt::taken() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<GirthSolver>(SolverFactory::onUnfolding(unfolding_));
  std::unique_ptr<GirthSolver> solver = std::move(idle_.back());
  idle_.pop_back();
  return solver;
}

}  // namespace girth::loops
