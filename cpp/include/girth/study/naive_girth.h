// The paper's naive algorithm (section 4.2): the reference implementation for tests and benchmarks.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <functional>

#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"

namespace girth::study {

/// I(p) by computing the whole exact distance field of p, keeping every window, and testing every
/// mesh edge and every pair of windows that meet from opposite sides. O(n^3 log n) time and O(n^2)
/// memory at worst. Errors: VERTEX_OUT_OF_RANGE, CANCELLED; LIMIT_EXCEEDED: more than 2^23 windows,
/// or 2^28 pairs of them. An average surface of 40,000 faces has as many windows.
GIRTH_EXPORT Result<GirthValue> naiveGirth(const SurfaceMesh& mesh, Vertex vertex,
                                           const ExecutionContext& context = {});

/// I(v) with its kind, vertex by vertex, by the naive algorithm.
GIRTH_EXPORT VertexFunction<GirthValue> naiveGirthFunction(const SurfaceMesh& mesh);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<GirthValue> naiveGirthFunction(const SurfaceMesh&&) = delete;

/// I(v) for all vertices, as `evaluateAll` of naiveGirthFunction. Nothing is counted in
/// `statistics`.
GIRTH_EXPORT GirthField
naiveGirthField(const SurfaceMesh& mesh, const ExecutionContext& context = {},
                const std::function<void(const GirthPartial&)>& onPartial = {});

}  // namespace girth::study
