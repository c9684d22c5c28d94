#include "girth/distance_field.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "geodesic/locate.h"
#include "geodesic/propagation.h"
#include "geodesic/stop_at_distance.h"
#include "infinity.h"
#include "mesh/check_vertex.h"
#include "no_value.h"

namespace girth {
namespace {

/// The distances of all vertices, found when the first is asked for.
struct DistanceField {
  explicit DistanceField(const SurfaceMesh& surface) : mesh(surface), unfolding(surface) {}

  /// Whether they are there: not where cancelled, and the next one asks again.
  bool find(const ExecutionContext& context) {
    const std::lock_guard lock(finding);
    if (!values.empty()) return true;
    geodesic::Propagation propagation(unfolding);
    propagation.allowWholeSurface();
    const double unit = unfolding.unit();
    geodesic::StopAtDistance stop([within = radius / unit] { return within; }, context);
    propagation.run(from, geodesic::Keep::Nothing, stop);
    if (stop.cancelled()) return false;
    if (propagation.gaveUp()) {
      values.assign(mesh.vertexCount(), kNoValue);
      return true;
    }
    values.assign(mesh.vertexCount(), kInfinity);
    for (Index v = 0; v < unfolding.vertexCount(); ++v) {
      const double distance = propagation.distance(v) * unit;
      if (distance <= radius) values[unfolding.vertexInMesh(v)] = distance;
    }
    return true;
  }

  const SurfaceMesh& mesh;
  geodesic::Unfolding unfolding;
  std::vector<SurfacePoint> from;  ///< points in the numbers of the unfolding
  double radius{0};
  std::mutex finding;
  std::vector<double> values;
};

}  // namespace

Result<VertexFunction<double>> distanceFunction(const SurfaceMesh& mesh,
                                                const DistanceFieldOptions& options) {
  if (!(options.radius >= 0)) {
    return makeError(ErrorCode::InvalidRadius, -1, "the radius is not a number of at least 0");
  }
  const auto field = std::make_shared<DistanceField>(mesh);
  field->radius = options.radius;
  std::vector<SurfacePoint> from = options.from;
  if (from.empty()) from.push_back(SurfacePoint::atVertex(Vertex(0)));
  for (const SurfacePoint& one : from) {
    const auto point = geodesic::locate(field->unfolding, one);
    if (!point) return point.error();
    field->from.push_back(point.value());
  }
  return VertexFunction<double>{
      [field](const ExecutionContext& context) -> VertexEvaluator<double> {
        return [field, own = context.ofOneThread()](Vertex v) -> Result<double> {
          if (auto error = checkVertex(field->mesh, v)) return *std::move(error);
          if (!field->find(own)) return makeError(ErrorCode::Cancelled, v, "cancelled");
          return field->values[v];
        };
      }};
}

}  // namespace girth
