#include "solver/refined/carried_loops.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "girth/parallel.h"
#include "idle_pool.h"
#include "mesh/nearest_point.h"
#include "mesh/vector.h"
#include "mesh/vertex_normals.h"
#include "solver/solver_factory.h"

namespace girth {

using geodesic::Unfolding;

namespace {

/// Finds faces of the fine surface beside points of the coarse one.
class Carrier {
 public:
  Carrier(const SurfaceMesh& coarse, const Unfolding& fine)
      : coarse_(coarse),
        fine_(fine),
        search_(searchOf(fine.mesh())),
        normals_(normalsOfFaces(fine.mesh())),
        coarseNormals_(normalsOfFaces(coarse)),
        vertexNormals_(normalsOfVertices(coarse)) {}

  CarriedLoop carried(Vertex base, const GirthLoop& loop) const {
    CarriedLoop result;
    const auto atBase = next(coarse_.position(base), vertexNormals_[base], kNoIndex);
    Index hint = atBase.triangle;
    const auto corner = static_cast<std::size_t>(
        std::max_element(atBase.weights.begin(), atBase.weights.end()) - atBase.weights.begin());
    const Vertex vertex = fine_.mesh().faceVertices(Face(atBase.triangle))[corner];
    result.vertex = fine_.fromMesh(SurfacePoint::atVertex(vertex)).element;
    const std::vector<Vec3> points = polyline(coarse_, loop);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec3 normal = normalBetween(loop.points[i], loop.points[i + 1]);
      const Vec3 step = points[i + 1] - points[i];
      const auto pieces =
          1 + static_cast<std::size_t>(std::sqrt(dot(step, step)) / fine_.meanEdgeLength());
      for (std::size_t k = 0; k < pieces; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(pieces);
        const auto found = next(points[i] + t * step, normal, hint);
        hint = found.triangle;
        // In the numbers of the unfolding.
        result.faces.push_back(
            fine_.fromMesh(SurfacePoint::inFace(Face(hint), {1.0 / 3, 1.0 / 3, 1.0 / 3})).element);
      }
    }
    return result;
  }

 private:
  NearestSearch::Found next(const Vec3& p, const Vec3& normal, Index hint) const {
    const auto found = search_.nearest(
        p, [&](Index face) { return dot(normals_[face], normal) >= 0; }, hint);
    return found.triangle == kNoIndex ? search_.nearest(p) : found;
  }

  /// The normal of the faces at both ends of a piece, which runs within one of them.
  Vec3 normalBetween(const SurfacePoint& a, const SurfacePoint& b) const {
    const Vec3 first = normalAt(a), second = normalAt(b);
    return first + second;
  }
  Vec3 normalAt(const SurfacePoint& point) const {
    switch (point.kind) {
      case SurfacePoint::Kind::AtVertex:
        return vertexNormals_[point.element];
      case SurfacePoint::Kind::OnEdge: {
        const Halfedge twin = coarse_.twin(point.halfedge());
        const Vec3 own = coarseNormals_[coarse_.faceOf(point.halfedge())];
        return twin == Halfedge::none ? own : own + coarseNormals_[coarse_.faceOf(twin)];
      }
      case SurfacePoint::Kind::InFace:
        break;
    }
    return coarseNormals_[point.element];
  }

  const SurfaceMesh& coarse_;
  const Unfolding& fine_;
  NearestSearch search_;
  std::vector<Vec3> normals_, coarseNormals_, vertexNormals_;
};

}  // namespace

Result<CarriedGirth> carriedGirth(const SurfaceMesh& coarse, const Unfolding& fine,
                                  const ExecutionContext& context) {
  const Carrier carrier(coarse, fine);
  const auto unfolding = std::make_shared<const Unfolding>(coarse);
  IdlePool<GirthSolver> solvers;
  CarriedGirth result;
  result.lengths.resize(coarse.vertexCount());
  std::vector<CarriedLoop> loops(coarse.vertexCount());
  const auto makeSolver = [&] {
    return std::make_unique<GirthSolver>(SolverFactory::onUnfolding(unfolding));
  };
  const auto carry = [&](std::size_t begin, std::size_t end) {
    solvers.use(makeSolver, [&](GirthSolver& solver) {
      for (std::size_t v = begin; v < end; ++v) {
        const Vertex vertex(static_cast<Index>(v));
        const auto loop = solver.loop(vertex, context.ofOneThread());
        if (!loop) return;  // cancelled
        result.lengths[v] = loop.value().length;
        if (loop.value().kind != LoopKind::Loop) continue;
        loops[v] = carrier.carried(vertex, loop.value());
      }
    });
  };
  constexpr std::size_t kGrain = 16;
  if (!parallelFor(loops.size(), kGrain, context, carry) || context.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "cancelled");
  }
  std::erase_if(loops, [](const CarriedLoop& loop) { return loop.vertex == kNoIndex; });
  std::stable_sort(loops.begin(), loops.end(),
                   [](const CarriedLoop& a, const CarriedLoop& b) { return a.vertex < b.vertex; });
  std::vector<CarriedLoop>& joined = result.loops;
  for (CarriedLoop& loop : loops) {
    if (joined.empty() || joined.back().vertex != loop.vertex) {
      joined.push_back(std::move(loop));
    } else {
      auto& faces = joined.back().faces;
      faces.insert(faces.end(), loop.faces.begin(), loop.faces.end());
    }
  }
  for (CarriedLoop& loop : joined) {
    std::sort(loop.faces.begin(), loop.faces.end());
    loop.faces.erase(std::unique(loop.faces.begin(), loop.faces.end()), loop.faces.end());
  }
  return result;
}

}  // namespace girth
