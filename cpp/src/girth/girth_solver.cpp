#include "girth/girth_solver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "geodesic/path_tracing.h"
#include "geodesic/propagation.h"
#include "girth/farthest_point.h"
#include "girth/loop_search.h"
#include "mesh/vector.h"

namespace girth {

using geodesic::Propagation;
using geodesic::samePoint;
using geodesic::Unfolding;

std::string_view toString(LoopKind kind) { return kind == LoopKind::Loop ? "loop" : "antipodal"; }

std::vector<Vec3> polyline(const SurfaceMesh& mesh, const GirthLoop& loop) {
  std::vector<Vec3> points(loop.points.size());
  std::transform(loop.points.begin(), loop.points.end(), points.begin(),
                 [&](const SurfacePoint& p) { return positionOf(mesh, p); });
  return points;
}

struct GirthSolver::State {
  std::shared_ptr<const Unfolding> unfolding;
  Propagation propagation;
  LoopSearch search;

  explicit State(std::shared_ptr<const Unfolding> shared)
      : unfolding(std::move(shared)), propagation(*unfolding), search(propagation) {}

  /// Propagates from a vertex until its loop is found or the surface is covered.
  std::optional<Error> run(Index vertex, const ExecutionContext& context) {
    const SurfaceMesh& mesh = unfolding->mesh();
    if (vertex >= mesh.vertexCount()) {
      return makeError(ErrorCode::VertexOutOfRange, vertex,
                       "there is no vertex " + std::to_string(vertex) + " among " +
                           std::to_string(mesh.vertexCount()));
    }
    search.start(context.cancel);
    propagation.run(vertex, search);
    if (search.cancelled()) {
      return makeError(ErrorCode::Cancelled, vertex,
                       "cancelled at vertex " + std::to_string(vertex));
    }
    return std::nullopt;
  }

  GirthValue value() const {
    if (!search.found()) {
      return {2 * farthestPoint(propagation).distance * unfolding->unit(), LoopKind::Antipodal};
    }
    const LoopCandidate& loop = search.best();
    return {loop.length * unfolding->unit(), kindOf(loop)};
  }

  /// On a sphere, a loop whose midpoint is reached from all sides is the special case of figure 1b.
  LoopKind kindOf(const LoopCandidate& loop) const {
    const SurfaceMesh& mesh = unfolding->mesh();
    const bool sphere = mesh.genus(mesh.componentOf(propagation.source())) == 0;
    return sphere && search.closesUpon(loop) ? LoopKind::Antipodal : LoopKind::Loop;
  }

  GirthLoop loop() const {
    GirthLoop result;
    result.base = propagation.source();
    std::vector<SurfacePoint> there, back;  // both run from the midpoint to the source
    if (search.found()) {
      const LoopCandidate& best = search.best();
      result.length = best.length * unfolding->unit();
      result.kind = kindOf(best);
      result.midpoint = surfacePointAt(*unfolding, best.face, best.midpoint);
      if (best.ends == LoopCandidate::Ends::VertexVertex) {
        traceFromVertex(propagation, unfolding->side(best.first).from, there);
        traceFromVertex(propagation, unfolding->side(SurfaceMesh::next(best.first)).from, back);
      } else {
        traceFromWindow(propagation, best.first, best.midpoint, there);
        if (best.ends == LoopCandidate::Ends::WindowWindow) {
          traceFromWindow(propagation, best.second, best.midpoint, back);
        } else {
          const Index h = propagation.window(best.first).halfedge;
          traceFromVertex(propagation, unfolding->side(SurfaceMesh::previous(h)).from, back);
        }
      }
    } else {
      const FarthestPoint farthest = farthestPoint(propagation);
      result.length = 2 * farthest.distance * unfolding->unit();
      result.kind = LoopKind::Antipodal;
      result.midpoint = surfacePointAt(*unfolding, farthest.face, farthest.point);
      const geodesic::PathEnd end = propagation.pathTo(farthest.face, farthest.point);
      if (end.window == kNoIndex) {
        traceFromVertex(propagation, end.corner, there);
      } else {
        traceFromWindow(propagation, end.window, farthest.point, there);
      }
      if (!samePoint(there.front(), result.midpoint)) there.insert(there.begin(), result.midpoint);
      back = there;
    }
    // Where the midpoint is a vertex or turning point, both halves begin with it.
    if (samePoint(there.front(), back.front())) back.erase(back.begin());
    result.points.assign(there.rbegin(), there.rend());
    result.points.insert(result.points.end(), back.begin(), back.end());
    result.angle = angleAtBase(result);
    return result;
  }

  /// Direction at the base in which a neighbouring point of the loop lies.
  double directionTo(Index base, const SurfacePoint& point) const {
    const SurfaceMesh& mesh = unfolding->mesh();
    Index h = mesh.outgoing(base);
    do {
      const Index opposite = SurfaceMesh::next(h);
      switch (point.kind) {
        case SurfacePoint::Kind::Vertex:
          if (mesh.to(h) == point.element) return unfolding->direction(h);
          break;
        case SurfacePoint::Kind::Edge:
          if (point.element == opposite || mesh.twin(point.element) == opposite) {
            const double t = point.element == opposite ? point.weights[1] : point.weights[0];
            return unfolding->directionTo(
                h, unfolding->side(opposite).at(t * unfolding->side(opposite).length));
          }
          break;
        case SurfacePoint::Kind::Face:
          if (SurfaceMesh::faceOf(h) == point.element) {
            const Index first = 3 * point.element;
            geodesic::Vec2 p;
            for (Index k = 0; k < 3; ++k)
              p = p + point.weights[k] * unfolding->side(first + k).start;
            return unfolding->directionTo(h, p);
          }
          break;
      }
      h = mesh.twin(SurfaceMesh::previous(h));
    } while (h != mesh.outgoing(base));
    return 0;
  }

  double angleAtBase(const GirthLoop& loop) const {
    const std::size_t n = loop.points.size();
    if (loop.kind == LoopKind::Antipodal && !search.found()) return 0;
    const double between = std::fabs(directionTo(loop.base, loop.points[1]) -
                                     directionTo(loop.base, loop.points[n - 2]));
    return std::min(between, unfolding->totalAngle(loop.base) - between);
  }
};

GirthSolver::GirthSolver(const SurfaceMesh& mesh)
    : GirthSolver(std::make_shared<const Unfolding>(mesh)) {}
GirthSolver::GirthSolver(std::shared_ptr<const Unfolding> unfolding)
    : state_(std::make_unique<State>(std::move(unfolding))) {}
GirthSolver::~GirthSolver() = default;
GirthSolver::GirthSolver(GirthSolver&&) noexcept = default;
GirthSolver& GirthSolver::operator=(GirthSolver&&) noexcept = default;

Result<GirthValue> GirthSolver::value(Index vertex, const ExecutionContext& context) {
  if (auto error = state_->run(vertex, context)) return *std::move(error);
  return state_->value();
}

Result<GirthLoop> GirthSolver::loop(Index vertex, const ExecutionContext& context) {
  if (auto error = state_->run(vertex, context)) return *std::move(error);
  return state_->loop();
}

std::size_t GirthSolver::windowCount() const { return state_->propagation.windowCount(); }
std::size_t GirthSolver::memoryBytes() const { return state_->propagation.memoryBytes(); }

Result<GirthLoop> girthLoop(const SurfaceMesh& mesh, Index vertex) {
  return GirthSolver(mesh).loop(vertex);
}

}  // namespace girth
