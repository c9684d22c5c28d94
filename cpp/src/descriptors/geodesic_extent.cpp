#include "girth/geodesic_extent.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "geodesic/fast_marching.h"
#include "geodesic/propagation.h"
#include "geodesic/stop_at_distance.h"
#include "girth/parallel.h"
#include "girth/vertex_areas.h"
#include "infinity.h"
#include "mesh/check_vertex.h"
#include "no_value.h"

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

/// Data that the vertices of a surface have in common.
struct SharedDistances {
  const SurfaceMesh& mesh;
  std::vector<double> areas;
  // One of the two, by the method.
  std::optional<geodesic::MarchingStencils> stencils;
  std::optional<geodesic::Unfolding> unfolding;

  SharedDistances(const SurfaceMesh& surface, DistanceMethod method)
      : mesh(surface), areas(vertexAreas(surface)) {
    if (method == DistanceMethod::FastMarching) stencils.emplace(surface);
    if (method == DistanceMethod::Exact) unfolding.emplace(surface);
  }
};

/// Mean and greatest distance from a vertex.
struct Extent {
  double average{kNoValue}, farthest{kNoValue};
};

/// Computes distances from one vertex after the other; one for each thread.
class ExtentSolver {
 public:
  explicit ExtentSolver(const SharedDistances& distances) : shared_(&distances) {
    if (distances.stencils) march_.emplace(*distances.stencils);
    if (distances.unfolding) propagation_.emplace(*distances.unfolding);
  }

  /// Without a value where cancelled.
  Extent at(Vertex vertex, const ExecutionContext& context) {
    Sum sum;
    double unit = 1;
    if (march_) {
      march_->run(vertex, [&](Index reached, double distance) {
        sum.add(distance, shared_->areas[reached]);
        return !context.cancelled();
      });
    } else {
      const geodesic::Unfolding& unfolding = *shared_->unfolding;
      const SurfacePoint source = unfolding.fromMesh(SurfacePoint::atVertex(vertex));
      geodesic::StopAtDistance visitor([] { return kInfinity; }, context);
      propagation_->run(std::span(&source, 1), geodesic::Keep::Nothing, visitor);
      if (propagation_->gaveUp()) return {};
      for (const Index reached : propagation_->reachedVertices()) {
        sum.add(propagation_->distance(reached), shared_->areas[unfolding.vertexInMesh(reached)]);
      }
      unit = unfolding.unit();
    }
    if (context.cancelled()) return {};
    return {sum.total / sum.weight * unit, sum.greatest * unit};
  }

 private:
  const SharedDistances* shared_;
  std::optional<geodesic::FastMarching> march_;
  std::optional<geodesic::Propagation> propagation_;
};

}  // namespace

GeodesicExtent geodesicExtent(const SurfaceMesh& mesh, DistanceMethod method,
                              const ExecutionContext& context) {
  GeodesicExtent extent;
  extent.average.assign(mesh.vertexCount(), kNoValue);
  extent.farthest.assign(mesh.vertexCount(), kNoValue);
  const SharedDistances distances(mesh, method);
  extent.complete =
      parallelFor(mesh.vertexCount(), kGrain, context, [&](std::size_t begin, std::size_t end) {
        ExtentSolver solver(distances);
        for (Vertex v(static_cast<Index>(begin)); v < end && !context.cancelled(); ++v) {
          const Extent found = solver.at(v, context);
          extent.average[v] = found.average;
          extent.farthest[v] = found.farthest;
        }
      });
  return extent;
}

VertexFunction<double> geodesicExtentFunction(const SurfaceMesh& mesh, ExtentMeasure measure,
                                              DistanceMethod method) {
  const auto distances = std::make_shared<const SharedDistances>(mesh, method);
  return {[distances, measure](const ExecutionContext& context) -> VertexEvaluator<double> {
    const auto solver = std::make_shared<ExtentSolver>(*distances);
    // The distances are held as long as the solver reads them.
    return [distances, solver, measure, own = context.ofOneThread()](Vertex v) -> Result<double> {
      if (auto error = checkVertex(distances->mesh, Vertex(v))) return *std::move(error);
      const Extent extent = solver->at(v, own);
      if (own.cancelled()) return makeError(ErrorCode::Cancelled, v, "cancelled");
      return measure == ExtentMeasure::Average ? extent.average : extent.farthest;
    };
  }};
}

}  // namespace girth
