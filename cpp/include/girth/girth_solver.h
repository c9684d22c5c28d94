// The intrinsic girth function at single points, and the loop that measures it.
#pragma once

#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "girth/execution.h"
#include "girth/export.h"
#include "girth/search_statistics.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// How the shortest loop came about (paper, section 3.1, figure 1).
enum class LoopKind : std::uint8_t {
  /// The frontier of the growing geodesic disk touched itself head-on: a loop around the surface.
  Loop = 0,
  /// The frontier vanished at one farthest point without a loop before: the "loop" is out and back
  /// again.
  Antipodal = 1,
  /// The budget was met first. The length is a lower bound, and `atMost` one from above.
  Unresolved = 2,
};

/// "loop", "antipodal" or "unresolved".
GIRTH_EXPORT std::string_view toString(LoopKind kind);

/// The girth at a point.
struct GirthValue {
  /// I(p), in model units; where unresolved, no more than I(p).
  double length{0};
  /// How it came about.
  LoopKind kind{LoopKind::Loop};
  /// I(p) is no more than this, in model units: the length itself, or, where unresolved, twice a
  /// distance that no point of the component exceeds. Infinite where nobody has looked.
  double atMost{std::numeric_limits<double>::infinity()};
};

/// The shortest geodesic loop based at a point.
struct GirthLoop {
  /// I(p), in model units; where unresolved, no more than I(p).
  double length{0};
  /// How it came about.
  LoopKind kind{LoopKind::Loop};
  /// As in GirthValue.
  double atMost{std::numeric_limits<double>::infinity()};
  /// The point p where the loop starts and ends.
  SurfacePoint base;
  /// The loop from p round to p: p, the edges it crosses and vertices it passes in order, p.
  /// Between neighbours it is straight inside one face or along one edge. An antipodal loop runs to
  /// `midpoint` and back the same way, and there the midpoint is one of the points. Empty where
  /// unresolved. Surfaces are cut along those of the kind Loop.
  std::vector<SurfacePoint> points;
  /// The loop's point farthest from p: length / 2 from p both ways, and both are shortest.
  SurfacePoint midpoint;
  /// Angle at p between the loop's two ends, inside the surface, on the smaller side, in radians.
  /// At least π: the loop is a closed geodesic. 0: antipodal.
  double angle{0};
};

/// The loop's points in space; the first equals the last.
///
/// \code
/// const girth::GirthLoop loop = girth::girthLoop(mesh, girth::Vertex{0}).value();
/// for (const girth::Vec3& p : girth::polyline(mesh, loop)) {
///   std::cout << p.x << ' ' << p.y << ' ' << p.z << '\n';
/// }
/// \endcode
GIRTH_EXPORT std::vector<Vec3> polyline(const SurfaceMesh& mesh, const GirthLoop& loop);

struct Barcode;
struct BarcodeOptions;

/// Computes I(p) by exact propagation of geodesic windows from p with early termination (paper,
/// sections 4.3 and 4.4, Algorithm 2), every loop proven by the distance of its midpoint.
///
/// Values are exact to rounding where no corner of a face is narrower than a millionth of a radian.
/// In needles beyond that, angles are made of the rounding errors of the coordinates, and values
/// near them can be off; faces flatter than a part in 10^12 are refused by `SurfaceMesh`.
///
/// Keeps its scratch memory between calls; one solver per thread. The mesh must outlive it: one
/// that would be gone at the end of the line is refused when the program is compiled. Time grows
/// with the windows inside the disk of radius I(p)/2, about O(n^1.5) for the usual mesh of n faces
/// where the disk is large; memory of `value` with the front of that disk, of loops with all of
/// it, and on more than 30,000 faces with the part of it on the way to the loop's midpoint or to
/// the farthest point.
///
/// \code
/// girth::GirthSolver solver(mesh);
/// for (const girth::Vertex vertex : mesh.vertices()) {
///   std::cout << solver.loop(vertex).value().length << '\n';
/// }
/// \endcode
class GIRTH_EXPORT GirthSolver {
 public:
  /// Prepares the faces of a surface. O(n log n).
  explicit GirthSolver(const SurfaceMesh& mesh);
  /// The mesh must outlive the solver: keep it in a variable.
  explicit GirthSolver(const SurfaceMesh&&) = delete;
  ~GirthSolver();
  /// Moves the scratch memory along.
  GirthSolver(GirthSolver&&) noexcept;
  /// Moves the scratch memory along.
  GirthSolver& operator=(GirthSolver&&) noexcept;

  /// I(p) for vertex p. The context serves to cancel only. Errors:
  /// VERTEX_OUT_OF_RANGE, INVALID_POINT, CANCELLED.
  Result<GirthValue> value(Vertex vertex, const ExecutionContext& context = {});
  /// I(p) for any point p. Context and errors are the same.
  Result<GirthValue> value(const SurfacePoint& point, const ExecutionContext& context = {});
  /// I(p) for vertex p with its loop. Context and errors are the same.
  Result<GirthLoop> loop(Vertex vertex, const ExecutionContext& context = {});
  /// I(p) for any point p with its loop. Context and errors are the same.
  Result<GirthLoop> loop(const SurfacePoint& point, const ExecutionContext& context = {});

  /// The saddles of the distance from vertex p, and how long they last (girth/barcode.h). Context
  /// and errors are the same, and INVALID_OPTION where `maxPersistence` is negative or NaN. O(s log
  /// s) for s saddles besides the propagation, which goes on to the first that lasts longer than
  /// `maxPersistence`, and as far beyond it.
  Result<Barcode> barcode(Vertex vertex, const BarcodeOptions& options,
                          const ExecutionContext& context = {});
  /// The barcode of any point p.
  Result<Barcode> barcode(const SurfacePoint& point, const BarcodeOptions& options,
                          const ExecutionContext& context = {});

  /// From now on `value` and `loop` give I_tau: the first loop whose saddle lasts longer than tau,
  /// in model units. 0, the default, is I itself. They report INVALID_OPTION where it is negative,
  /// infinite or NaN. Unresolved values are lower bounds of I_tau.
  void setPersistence(double tau);
  /// Calls give up with LoopKind::Unresolved after so many windows, or as much work on pairs of
  /// windows, loops and the farthest point. Default: 2^26.
  void setBudget(std::size_t windows);
  /// The cost of the last call.
  SearchStatistics statistics() const;

 private:
  friend struct SolverFactory;
  struct State;
  explicit GirthSolver(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// One loop, for a single use.
///
/// \code
/// const girth::GirthLoop loop = girth::girthLoop(mesh, girth::Vertex{0}).value();
/// std::cout << loop.length << ' ' << girth::toString(loop.kind) << '\n';
/// \endcode
GIRTH_EXPORT Result<GirthLoop> girthLoop(const SurfaceMesh& mesh, Vertex vertex);

}  // namespace girth
