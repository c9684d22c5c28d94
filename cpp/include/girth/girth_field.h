// The intrinsic girth function at all vertices, on all threads.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "girth/barcode.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"
#include "girth/vertex_function.h"

namespace girth {

/// The ways to compute the function (web/docs/definitions.md, section 3).
enum class GirthMethod : std::uint8_t {
  /// GirthSolver: early termination, windows near the frontier only. The default.
  Exact,
  /// IGF-MS, the paper's approximation (section 6.1): twice the distance, by fast marching, of the
  /// nearest vertex that is a saddle of the distance field.
  Marched,
};

/// The girth at vertices that were not computed: NaN.
template <>
inline constexpr GirthValue kNotComputed<GirthValue>{std::numeric_limits<double>::quiet_NaN(),
                                                     LoopKind::Loop};

/// The barcode at vertices that were not computed: one without bars, of which nothing is known.
template <>
inline const Barcode kNotComputed<Barcode>{};

/// The girth of a surface, in the order of its vertices.
struct GirthField {
  /// I(v) in model units; NaN at vertices that were not reached before the work was cancelled.
  std::vector<double> values;
  /// How each value came about.
  std::vector<LoopKind> kinds;
  /// Vertices computed; less than all of them only after cancelling.
  std::size_t computed{0};
  /// The cost of computing it.
  SearchStatistics statistics;

  /// Whether all vertices have been computed.
  bool complete() const { return computed == values.size(); }
};

/// Values that were finished since the last report.
using GirthPartial = VertexPartial<GirthValue>;

/// The girth that is computed: its method and its persistence.
struct GirthOptions {
  /// How.
  GirthMethod method{GirthMethod::Exact};
  /// tau of I_tau, in model units (girth/barcode.h); 0: I. Only with `Exact`. Where it is negative,
  /// infinite or NaN (`checkPersistence`), or not 0 with another method, nothing is computed.
  double persistence{0};
};

/// I(v) for all vertices, as `evaluateAll` of girthFunction.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// std::cout << *std::min_element(field.values.begin(), field.values.end()) << '\n';
/// \endcode
GIRTH_EXPORT GirthField girthField(const SurfaceMesh& mesh, GirthMethod method = GirthMethod::Exact,
                                   const ExecutionContext& context = {},
                                   const std::function<void(const GirthPartial&)>& onPartial = {});

/// I(v) or I_tau(v) at all vertices: `girthField(mesh, {.persistence = 0.5})`.
GIRTH_EXPORT GirthField girthField(const SurfaceMesh& mesh, const GirthOptions& options,
                                   const ExecutionContext& context = {},
                                   const std::function<void(const GirthPartial&)>& onPartial = {});

/// The lengths and kinds of values, each in an array of its own.
GIRTH_EXPORT GirthField girthFieldOf(const VertexValues<GirthValue>& girth);

/// I(v), exactly, in model units, with its kind.
GIRTH_EXPORT VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh);
/// The girth as a function of vertices, by a method.
GIRTH_EXPORT VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh, GirthMethod method);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<GirthValue> girthFunction(const SurfaceMesh&&,
                                         GirthMethod method = GirthMethod::Exact) = delete;

/// I_tau(v), in model units, with its kind. Its evaluators report INVALID_OPTION where the options
/// are none.
GIRTH_EXPORT VertexFunction<GirthValue> girthFunction(const SurfaceMesh& mesh,
                                                      const GirthOptions& options);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<GirthValue> girthFunction(const SurfaceMesh&&, const GirthOptions&) = delete;

/// The barcode of every vertex, from which I_tau is read for any tau up to `maxPersistence`.
GIRTH_EXPORT VertexFunction<Barcode> barcodeFunction(const SurfaceMesh& mesh,
                                                     const BarcodeOptions& options);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<Barcode> barcodeFunction(const SurfaceMesh&&, const BarcodeOptions&) = delete;

/// The angle at v between the two ends of the loop through it (GirthLoop::angle), in radians; NaN
/// where the loop is unresolved.
GIRTH_EXPORT VertexFunction<double> loopAngleFunction(const SurfaceMesh& mesh);
/// The angle of the loop of I_tau. `persistence`: tau, in model units; INVALID_OPTION where it is
/// none (`checkPersistence`).
GIRTH_EXPORT VertexFunction<double> loopAngleFunction(const SurfaceMesh& mesh, double persistence);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<double> loopAngleFunction(const SurfaceMesh&&, double persistence = 0) = delete;

}  // namespace girth
