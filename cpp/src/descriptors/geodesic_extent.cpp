#include "girth/geodesic_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "geodesic/fast_marching.h"
#include "geodesic/propagation.h"
#include "girth/vertex_areas.h"
#include "parallel.h"

namespace girth {

namespace {

constexpr std::size_t kGrain = 16;

/// Adds up the distances from one vertex.
struct Sum {
  double weight{0}, total{0}, greatest{0};
  void add(double distance, double area) {
    weight += area;
    total += area * distance;
    greatest = std::max(greatest, distance);
  }
};

/// Lets a propagation run to its end, or until told to stop.
struct UntilCancelled {
  const ExecutionContext& context;
  bool enough(double) const { return context.cancelled(); }
  void onCrossing(Index, std::uint32_t, const geodesic::CrossingResult&) {}
  void onVertex(Index) {}
  std::size_t effort() const { return 0; }
};

}  // namespace

GeodesicExtent geodesicExtent(const SurfaceMesh& mesh, DistanceMethod method,
                              const ExecutionContext& context) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  GeodesicExtent extent;
  extent.average.assign(mesh.vertexCount(), none);
  extent.farthest.assign(mesh.vertexCount(), none);
  const std::vector<double> areas = vertexAreas(mesh);
  const auto store = [&](Index vertex, const Sum& sum, double unit) {
    if (context.cancelled()) return;
    extent.average[vertex] = sum.total / sum.weight * unit;
    extent.farthest[vertex] = sum.greatest * unit;
  };
  if (method == DistanceMethod::FastMarching) {
    const geodesic::MarchingStencils stencils(mesh);
    extent.complete =
        inParallel(mesh.vertexCount(), kGrain, context, [&](std::size_t begin, std::size_t end) {
          geodesic::FastMarching march(stencils);
          for (auto v = static_cast<Index>(begin); v < end && !context.cancelled(); ++v) {
            Sum sum;
            march.run(v, [&](Index vertex, double distance) {
              sum.add(distance, areas[vertex]);
              return !context.cancelled();
            });
            store(v, sum, 1);
          }
        });
  } else {
    const geodesic::Unfolding unfolding(mesh);
    extent.complete =
        inParallel(mesh.vertexCount(), kGrain, context, [&](std::size_t begin, std::size_t end) {
          geodesic::Propagation propagation(unfolding);
          UntilCancelled visitor{context};
          for (auto v = static_cast<Index>(begin); v < end && !context.cancelled(); ++v) {
            const SurfacePoint source = unfolding.fromMesh(SurfacePoint::atVertex(v));
            propagation.run(std::span(&source, 1), geodesic::Keep::Nothing, visitor);
            Sum sum;
            for (const Index reached : propagation.reachedVertices()) {
              sum.add(propagation.distance(reached), areas[unfolding.vertexInMesh(reached)]);
            }
            store(v, sum, unfolding.unit());
          }
        });
  }
  return extent;
}

}  // namespace girth
