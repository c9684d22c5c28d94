#include "girth/girth_field.h"

#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include "geodesic/fast_marching.h"
#include "geodesic/unfolding.h"
#include "girth/marched_girth.h"
#include "mesh/check_vertex.h"

namespace girth {

namespace {

/// What the solvers of several threads cost, added up when each of them ends.
class Costs {
 public:
  void add(const SearchStatistics& statistics) {
    const std::lock_guard lock(mutex_);
    sum_ += statistics;
  }
  const SearchStatistics& sum() const { return sum_; }

 private:
  std::mutex mutex_;
  SearchStatistics sum_;
};

/// A solver that tells at its end what all its calls cost.
class CountedSolver {
 public:
  CountedSolver(std::shared_ptr<const geodesic::Unfolding> unfolding, std::shared_ptr<Costs> costs)
      : solver_(std::move(unfolding)), costs_(std::move(costs)) {}
  CountedSolver(const CountedSolver&) = delete;
  CountedSolver& operator=(const CountedSolver&) = delete;
  ~CountedSolver() {
    if (costs_) costs_->add(statistics_);
  }

  Result<GirthValue> value(Index vertex, const ExecutionContext& context) {
    auto value = solver_.value(vertex, context);
    if (value) statistics_ += solver_.statistics();
    return value;
  }

 private:
  GirthSolver solver_;
  std::shared_ptr<Costs> costs_;
  SearchStatistics statistics_;
};

Result<VertexValue> asVertexValue(const Result<GirthValue>& girth) {
  if (!girth) return girth.error();
  return VertexValue{girth.value().length, girth.value().kind};
}

VertexFunction countedFunction(const SurfaceMesh& mesh, GirthMethod method,
                               const std::shared_ptr<Costs>& costs) {
  switch (method) {
    case GirthMethod::Exact: {
      const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
      return {[unfolding, costs](const ExecutionContext& context) -> VertexEvaluator {
        const auto solver = std::make_shared<CountedSolver>(unfolding, costs);
        return [solver, &context](Index v) { return asVertexValue(solver->value(v, context)); };
      }};
    }
    case GirthMethod::Marched:
      break;
  }
  const auto stencils = std::make_shared<const geodesic::MarchingStencils>(mesh);
  return {[&mesh, stencils](const ExecutionContext& context) -> VertexEvaluator {
    const auto march = std::make_shared<geodesic::FastMarching>(*stencils);
    // The stencils are held as long as the march reads them.
    return [&mesh, stencils, march, &context](Index v) -> Result<VertexValue> {
      if (auto error = checkVertex(mesh, v)) return *std::move(error);
      const GirthValue girth = marchedGirth(*march, mesh, v, context);
      if (context.cancelled()) return makeError(ErrorCode::Cancelled, v, "cancelled");
      return VertexValue{girth.length, girth.kind};
    };
  }};
}

}  // namespace

VertexFunction girthFunction(const SurfaceMesh& mesh, GirthMethod method) {
  return countedFunction(mesh, method, nullptr);
}

VertexFunction loopAngleFunction(const SurfaceMesh& mesh) {
  const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
  return {[unfolding](const ExecutionContext& context) -> VertexEvaluator {
    const auto solver = std::make_shared<GirthSolver>(unfolding);
    return [solver, &context](Index v) -> Result<VertexValue> {
      const auto loop = solver->loop(v, context);
      if (!loop) return loop.error();
      const bool isResolved = loop.value().kind != LoopKind::Unresolved;
      return VertexValue{isResolved ? loop.value().angle
                                    : std::numeric_limits<double>::quiet_NaN()};
    };
  }};
}

GirthField girthField(const SurfaceMesh& mesh, GirthMethod method, const ExecutionContext& context,
                      const std::function<void(const VertexPartial&)>& onPartial) {
  const auto costs = std::make_shared<Costs>();
  GirthField field{evaluateAll(mesh, countedFunction(mesh, method, costs), context, onPartial), {}};
  field.statistics = costs->sum();
  return field;
}

}  // namespace girth
