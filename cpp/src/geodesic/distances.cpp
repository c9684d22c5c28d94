#include "girth/distances.h"

#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>

#include "girth/geodesic_solver.h"
#include "girth/parallel.h"
#include "mesh/vector.h"

namespace girth {
namespace {

/// So many paths are found by one solver, whose preparation takes as long as a short path.
constexpr std::size_t kPathsAtOnce = 8;

}  // namespace

Result<Distances> findDistances(const SurfaceMesh& mesh, const DistancesOptions& options,
                                const ExecutionContext& context) {
  Distances found;
  found.distances.resize(options.pairs.size());
  std::mutex failing;
  std::optional<std::pair<std::size_t, Error>> failed;
  const bool isDone = parallelFor(
      options.pairs.size(), kPathsAtOnce, context, [&](std::size_t first, std::size_t last) {
        GeodesicSolver solver(mesh);
        for (std::size_t i = first; i < last; ++i) {
          const auto& [start, end] = options.pairs[i];
          auto path = solver.path(start, end, {1, context.cancel, {}});
          if (!path) {
            const std::lock_guard lock(failing);
            if (!failed || i < failed->first) failed.emplace(i, path.error());
            return;
          }
          const double straight = norm(positionOf(mesh, end) - positionOf(mesh, start));
          found.distances[i] = {start, end, path.value().length, straight, {}};
          if (options.paths) found.distances[i].points = std::move(path.value().points);
        }
      });
  if (!isDone) return makeError(ErrorCode::Cancelled, -1, "the distances were cancelled");
  if (failed) return std::move(failed->second);
  return found;
}

}  // namespace girth
