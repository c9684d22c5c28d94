// The girth at many points, on all threads.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "geodesic/unfolding.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/girth_solver.h"
#include "idle_pool.h"

namespace girth::loops {

/// Keeps a solver for each thread from one call to the next.
class GirthAt {
 public:
  /// Takes threads and `cancel` of the context; nothing else of it matters.
  GirthAt(std::shared_ptr<const geodesic::Unfolding> unfolding, const ExecutionContext& context);

  /// At points of the surface. Progress is reported to `onProgress`, where given. Error: CANCELLED.
  Result<std::vector<GirthValue>> values(std::span<const SurfacePoint> points,
                                         const std::function<void(double)>& onProgress = {});
  /// The points of the loops; none where there is no loop. Error: CANCELLED.
  Result<std::vector<std::vector<SurfacePoint>>> loops(std::span<const SurfacePoint> points);
  /// The lengths alone.
  Result<std::vector<double>> lengths(std::span<const SurfacePoint> points);

 private:
  std::function<std::unique_ptr<GirthSolver>()> make_;
  ExecutionContext context_;
  IdlePool<GirthSolver> solvers_;
};

}  // namespace girth::loops
