#include "girth/girth_field.h"

#include <memory>
#include <mutex>
#include <utility>

#include "geodesic/fast_marching.h"
#include "geodesic/unfolding.h"
#include "mesh/check_vertex.h"
#include "no_value.h"
#include "solver/marched/marched_girth.h"
#include "solver/solver_factory.h"

namespace girth {

namespace {

/// The costs of the solvers of several threads, added up when each of them ends.
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

/// A solver that reports at its end what all its calls cost.
class CountedSolver {
 public:
  CountedSolver(GirthSolver solver, std::shared_ptr<Costs> costs)
      : solver_(std::move(solver)), costs_(std::move(costs)) {}
  CountedSolver(const CountedSolver&) = delete;
  CountedSolver& operator=(const CountedSolver&) = delete;
  ~CountedSolver() {
    if (costs_) costs_->add(statistics_);
  }

  Result<GirthValue> value(Vertex vertex, const ExecutionContext& context) {
    auto value = solver_.value(vertex, context);
    if (value) statistics_ += solver_.statistics();
    return value;
  }

 private:
  GirthSolver solver_;
  std::shared_ptr<Costs> costs_;
  SearchStatistics statistics_;
};

/// Makes the solvers of a field.
class PlainSolvers {
 public:
  explicit PlainSolvers(const SurfaceMesh& mesh)
      : unfolding_(std::make_shared<const geodesic::Unfolding>(mesh)) {}
  GirthSolver operator()() const { return SolverFactory::onUnfolding(unfolding_); }

 private:
  std::shared_ptr<const geodesic::Unfolding> unfolding_;
};

/// Solvers with a persistence. A class of its own, so that a program that has no use for it is
/// linked without the search for saddles that last.
class PersistentSolvers {
 public:
  PersistentSolvers(const SurfaceMesh& mesh, double persistence)
      : plain_(mesh), persistence_(persistence) {}
  GirthSolver operator()() const {
    GirthSolver solver = plain_();
    solver.setPersistence(persistence_);
    return solver;
  }

 private:
  PlainSolvers plain_;
  double persistence_;
};

template <class Solvers>
VertexFunction<GirthValue> exactFunction(const Solvers& solvers,
                                         const std::shared_ptr<Costs>& costs) {
  return {[solvers, costs](const ExecutionContext& context) -> VertexEvaluator<GirthValue> {
    const auto solver = std::make_shared<CountedSolver>(solvers(), costs);
    return [solver, own = context.ofOneThread()](Vertex v) { return solver->value(v, own); };
  }};
}

VertexFunction<GirthValue> countedFunction(const SurfaceMesh& mesh, const GirthOptions& options,
                                           const std::shared_ptr<Costs>& costs) {
  if (options.method == GirthMethod::Exact) {
    return exactFunction(PersistentSolvers(mesh, options.persistence), costs);
  }
  if (options.persistence != 0) {
    return {[](const ExecutionContext&) -> VertexEvaluator<GirthValue> {
      return [](Vertex) -> Result<GirthValue> {
        return makeError(ErrorCode::InvalidOption, -1,
                         "only the exact method knows how long saddles last");
      };
    }};
  }
  const auto stencils = std::make_shared<const geodesic::MarchingStencils>(mesh);
  return {[&mesh, stencils](const ExecutionContext& context) -> VertexEvaluator<GirthValue> {
    const auto march = std::make_shared<geodesic::FastMarching>(*stencils);
    // The stencils are held as long as the march reads them.
    return [&mesh, stencils, march, own = context.ofOneThread()](Vertex v) -> Result<GirthValue> {
      if (auto error = checkVertex(mesh, Vertex(v))) return *std::move(error);
      const GirthValue girth = marchedGirth(*march, mesh, v, own);
      if (own.cancelled()) return makeError(ErrorCode::Cancelled, v, "cancelled");
      return girth;
    };
  }};
}

template <class Solvers>
VertexFunction<double> angleFunction(const Solvers& solvers) {
  return {[solvers](const ExecutionContext& context) -> VertexEvaluator<double> {
    const auto solver = std::make_shared<GirthSolver>(solvers());
    return [solver, own = context.ofOneThread()](Vertex v) -> Result<double> {
      const auto loop = solver->loop(v, own);
      if (!loop) return loop.error();
      const bool isResolved = loop.value().kind != LoopKind::Unresolved;
      return isResolved ? loop.value().angle : kNoValue;
    };
  }};
}

}  // namespace

VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh) {
  return exactFunction(PlainSolvers(mesh), nullptr);
}

VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh, GirthMethod method) {
  return countedFunction(mesh, {method}, nullptr);
}

VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh, const GirthOptions& options) {
  return countedFunction(mesh, options, nullptr);
}

VertexFunction<Barcode> barcodeFunction(const SurfaceMesh& mesh, const BarcodeOptions& options) {
  const PlainSolvers solvers(mesh);
  return {[solvers, options](const ExecutionContext& context) -> VertexEvaluator<Barcode> {
    const auto solver = std::make_shared<GirthSolver>(solvers());
    return [solver, options, own = context.ofOneThread()](Vertex v) {
      return solver->barcode(v, options, own);
    };
  }};
}

VertexFunction<double> loopAngleFunction(const SurfaceMesh& mesh) {
  return angleFunction(PlainSolvers(mesh));
}

VertexFunction<double> loopAngleFunction(const SurfaceMesh& mesh, double persistence) {
  return angleFunction(PersistentSolvers(mesh, persistence));
}

GirthField girthFieldOf(const VertexValues<GirthValue>& girth) {
  GirthField field;
  field.values.reserve(girth.values.size());
  field.kinds.reserve(girth.values.size());
  for (const GirthValue& value : girth.values) {
    field.values.push_back(value.length);
    field.kinds.push_back(value.kind);
  }
  field.computed = girth.computed;
  return field;
}

GirthField girthField(const SurfaceMesh& mesh, GirthMethod method, const ExecutionContext& context,
                      const std::function<void(const GirthPartial&)>& onPartial) {
  return girthField(mesh, GirthOptions{method}, context, onPartial);
}

GirthField girthField(const SurfaceMesh& mesh, const GirthOptions& options,
                      const ExecutionContext& context,
                      const std::function<void(const GirthPartial&)>& onPartial) {
  const auto costs = std::make_shared<Costs>();
  GirthField field =
      girthFieldOf(evaluateAll(mesh, countedFunction(mesh, options, costs), context, onPartial));
  field.statistics = costs->sum();
  return field;
}

}  // namespace girth
