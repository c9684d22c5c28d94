// The intrinsic girth function at all vertices, on all threads.
#pragma once

#include <functional>

#include "girth/execution.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"
#include "girth/vertex_function.h"

namespace girth {

/// The ways to compute the function (DEFINITIONS section 3).
enum class GirthMethod : std::uint8_t {
  /// GirthSolver: early termination, windows near the frontier only. The default.
  Exact,
  /// IGF-MS, the paper's approximation (section 6.1): twice the distance, by fast marching, of the
  /// nearest vertex that is a saddle of the distance field.
  Marched,
};

/// I(v) in model units for every vertex.
struct GirthField : VertexValues {
  /// What it cost.
  SearchStatistics statistics;
};

/// I(v) for all vertices, as `evaluateAll` of girthFunction.
GirthField girthField(const SurfaceMesh& mesh, GirthMethod method = GirthMethod::Exact,
                      const ExecutionContext& context = {},
                      const std::function<void(const VertexPartial&)>& onPartial = {});

/// I(v), in model units, with its kind.
VertexFunction girthFunction(const SurfaceMesh& mesh, GirthMethod method = GirthMethod::Exact);

/// The angle at v between the two ends of the loop through it (GirthLoop::angle), in radians; NaN
/// where the loop is unresolved.
VertexFunction loopAngleFunction(const SurfaceMesh& mesh);

}  // namespace girth
