// Exact geodesic distances and shortest paths: the engine under the girth function, for itself.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "girth/execution.h"
#include "girth/export.h"
#include "girth/search_statistics.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// A shortest path between two points of a surface.
struct GeodesicPath {
  /// In model units; infinite where the points lie in different components.
  double length{std::numeric_limits<double>::infinity()};
  /// From the first point to the second: the edges crossed and vertices passed in order. Between
  /// neighbours the path is straight inside one face or along one edge. Empty where there is none.
  std::vector<SurfacePoint> points;
};

/// Computes distances by exact propagation of geodesic windows (paper, section 4.1; Mitchell et al.
/// 1987, Chen and Han 1990, Xin and Wang 2009), all windows of a halfedge at a time.
///
/// Keeps its scratch memory between calls; one solver per thread. The mesh must outlive it: one
/// that would be gone at the end of the line is refused when the program is compiled. Memory of a
/// call grows with the front, that of `path` with all windows up to the second point, and on more
/// than 30,000 faces with those on the way there. Time is about O(n^1.5) for the usual mesh of n
/// faces.
///
/// \code
/// girth::GeodesicSolver solver(mesh);
/// const auto start = girth::SurfacePoint::atVertex(girth::Vertex{0});
/// const auto end = girth::SurfacePoint::inFace(girth::Face{2}, {0.2, 0.3, 0.5});
/// std::cout << solver.path(start, end).value().length << '\n';
/// \endcode
class GIRTH_EXPORT GeodesicSolver {
 public:
  /// Lays the faces flat. O(n log n).
  explicit GeodesicSolver(const SurfaceMesh& mesh);
  /// The mesh must outlive the solver: keep it in a variable.
  explicit GeodesicSolver(const SurfaceMesh&&) = delete;
  ~GeodesicSolver();
  /// Solvers can be moved, not copied.
  GeodesicSolver(GeodesicSolver&&) noexcept;
  /// Solvers can be assigned by moving.
  GeodesicSolver& operator=(GeodesicSolver&&) noexcept;

  /// Distance of every vertex from the source, in model units; infinite beyond the radius and in
  /// other components. The context serves to cancel only. Errors: VERTEX_OUT_OF_RANGE,
  /// INVALID_POINT, INVALID_RADIUS (negative, or not a number), CANCELLED, LIMIT_EXCEEDED (more
  /// than the budget of windows).
  Result<std::vector<double>> distances(const SurfacePoint& source,
                                        double radius = std::numeric_limits<double>::infinity(),
                                        const ExecutionContext& context = {});
  /// Distance from the nearest of several sources; all infinite where there are none.
  Result<std::vector<double>> distances(std::span<const SurfacePoint> sources,
                                        double radius = std::numeric_limits<double>::infinity(),
                                        const ExecutionContext& context = {});

  /// A shortest path from one point to another. Errors are the same.
  Result<GeodesicPath> path(const SurfacePoint& from, const SurfacePoint& to,
                            const ExecutionContext& context = {});

  /// Calls give up with LIMIT_EXCEEDED after this number of windows. Default: 2^26, and n^1.5 on
  /// more than 165,000 faces, several times as many as usual meshes need.
  void setBudget(std::size_t windows);
  /// The cost of the last call.
  SearchStatistics statistics() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace girth
