#include "surface.h"

#include <utility>

namespace girth::python {
namespace {

Error stopped() { return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"); }

/// Calls `use` with the solver that is kept, or where another thread has it, with a new one.
template <class Solver, class Use>
auto withSolver(std::mutex& mutex, std::optional<Solver>& kept, const SurfaceMesh& mesh,
                const Use& use) {
  const std::unique_lock lock(mutex, std::try_to_lock);
  if (!lock.owns_lock()) {
    Solver solver(mesh);
    return use(solver);
  }
  try {
    if (!kept) kept.emplace(mesh);
    return use(*kept);
  } catch (...) {
    // Out of memory in the middle of something.
    kept.reset();
    throw;
  }
}

}  // namespace

Surface::Surface(io::LoadedMesh loaded) : loaded_(std::move(loaded)) {}

Result<std::shared_ptr<const GirthField>> Surface::girth(double persistence,
                                                         const ExecutionContext& context) const {
  if (auto error = checkPersistence(persistence)) return *std::move(error);
  {
    const std::lock_guard lock(fields_);
    if (persistence == 0 && girth_) return girth_;
    if (persistence == persistence_ && persistentGirth_) return persistentGirth_;
  }
  auto field = std::make_shared<const GirthField>(
      girthField(mesh(), {GirthMethod::Exact, persistence}, context));
  if (!field->complete()) return stopped();
  const std::lock_guard lock(fields_);
  if (persistence == 0) return girth_ = field;
  persistence_ = persistence;
  return persistentGirth_ = field;
}

Result<std::shared_ptr<const std::vector<double>>> Surface::diameter(
    const ExecutionContext& context) const {
  {
    const std::lock_guard lock(fields_);
    if (diameter_) return diameter_;
  }
  auto field = shapeDiameter(mesh(), {}, context);
  if (!field) return field.error();
  if (!field.value().complete) return stopped();
  const std::lock_guard lock(fields_);
  diameter_ = std::make_shared<const std::vector<double>>(std::move(field.value().values));
  return diameter_;
}

Result<GirthLoop> Surface::loop(const SurfacePoint& point, double persistence,
                                const ExecutionContext& context) const {
  return withSolver(loops_, loopSolver_, mesh(), [&](GirthSolver& solver) {
    solver.setPersistence(persistence);
    return solver.loop(point, context);
  });
}

Result<Barcode> Surface::barcode(const SurfacePoint& point, const BarcodeOptions& options,
                                 const ExecutionContext& context) const {
  return withSolver(loops_, loopSolver_, mesh(),
                    [&](GirthSolver& solver) { return solver.barcode(point, options, context); });
}

Result<std::vector<double>> Surface::distances(const std::vector<SurfacePoint>& sources,
                                               double radius,
                                               const ExecutionContext& context) const {
  return withSolver(geodesics_, geodesicSolver_, mesh(), [&](GeodesicSolver& solver) {
    return solver.distances(sources, radius, context);
  });
}

Result<GeodesicPath> Surface::path(const SurfacePoint& from, const SurfacePoint& to,
                                   const ExecutionContext& context) const {
  return withSolver(geodesics_, geodesicSolver_, mesh(),
                    [&](GeodesicSolver& solver) { return solver.path(from, to, context); });
}

}  // namespace girth::python
