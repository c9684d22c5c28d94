#include "geodesic/corridor.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/stop_at_distance.h"

namespace girth::geodesic {

std::optional<Goal> corridor(Propagation& propagation, const SurfacePoint& from,
                             const SurfacePoint& to, double length,
                             const ExecutionContext& context) {
  const Unfolding& unfolding = propagation.unfolding();
  const auto straightTo = [&](const SurfacePoint& point) {
    return Goal(unfolding, positionOf(unfolding.mesh(), unfolding.toMesh(point)), length);
  };
  const Goal back = straightTo(from), straight = straightTo(to);
  StopAtDistance stop([length] { return length; }, context);
  propagation.run(std::span(&to, 1), Keep::Nothing, stop, &back);
  if (stop.cancelled() || propagation.gaveUp()) return std::nullopt;

  // Vertices that this search left out are too far from there for a way between the two.
  std::vector<double> least(unfolding.vertexCount());
  for (Index v = 0; v < least.size(); ++v) {
    least[v] = std::max(straight.leastFrom(v), std::min(propagation.distance(v), back.mostTo(v)));
  }
  return Goal(unfolding, std::move(least), length);
}

}  // namespace girth::geodesic
