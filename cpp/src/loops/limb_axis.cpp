#include "girth/limb_axis.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/path_profile.h"
#include "loops/tight/loop_shape.h"
#include "mesh/vector.h"
#include "part_of_work.h"
#include "solver/solver_factory.h"

namespace girth {
namespace {

/// Middles nearer to each other than this share of the loop are one.
constexpr double kSameMiddle = 1e-9;

/// The share of the work that is the girth at the places.
constexpr double kPlacesShare = 0.4;

/// Stations that one solver traces before another thread may take the next ones.
constexpr std::size_t kGrain = 8;

}  // namespace

Result<std::vector<AxisStation>> limbAxis(const SurfaceMesh& mesh, const GirthProfile& profile,
                                          const ExecutionContext& context) {
  const auto hasLoop = [](const GirthStation& station) { return !std::isnan(station.least); };
  const auto first = std::find_if(profile.begin(), profile.end(), hasLoop);
  const auto last = std::find_if(profile.rbegin(), profile.rend(), hasLoop);
  if (first == profile.end()) return std::vector<AxisStation>{};
  GeodesicSolver geodesics(mesh);
  const auto path = geodesics.path(first->place, last->place, context.ofOneThread());
  if (!path) return path.error();
  if (path.value().points.empty()) {
    return makeError(ErrorCode::InvalidPoint, -1, "the stations lie in different components");
  }
  const auto count =
      static_cast<std::size_t>(std::count_if(profile.begin(), profile.end(), hasLoop));
  const auto places =
      girthAlong(mesh, path.value().points, {std::max<std::size_t>(count, 2), false},
                 partOf(context, 0, kPlacesShare));
  if (!places) return places.error();
  std::vector<AxisStation> all(places.value().size());
  const ExecutionContext rest = partOf(context, kPlacesShare, 1);
  const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
  const bool isDone =
      parallelFor(all.size(), kGrain, rest, [&](std::size_t begin, std::size_t end) {
        GirthSolver solver = SolverFactory::onUnfolding(unfolding);
        for (std::size_t i = begin; i < end; ++i) {
          const PathStation& place = places.value()[i];
          if (place.kind != LoopKind::Loop) continue;
          auto loop = solver.loop(place.point, context.ofOneThread());
          if (!loop) continue;  // cancelled
          AxisStation& station = all[i];
          station.along = first->distance + place.distance;
          station.girth = loop.value().length;
          station.points = std::move(loop).value().points;
          const loops::LoopShape shape = loops::shapeOf(loops::placesOf(mesh, station.points));
          station.centre = shape.centre;
          station.area = shape.area;
        }
      });
  if (!isDone || context.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "the search for an axis was cancelled");
  }
  std::vector<AxisStation> axis;
  for (AxisStation& station : all) {
    if (station.points.empty()) continue;
    if (!axis.empty()) {
      const double step = norm(station.centre - axis.back().centre);
      if (step <= kSameMiddle * station.girth) continue;
      station.distance = axis.back().distance + step;
    }
    axis.push_back(std::move(station));
  }
  return axis;
}

}  // namespace girth
