// The intrinsic girth function at all vertices, on all threads.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "girth/execution.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The ways to compute the function (DEFINITIONS section 3).
enum class GirthMethod : std::uint8_t {
  /// GirthSolver: early termination, windows near the frontier only. The default.
  Exact,
  /// The paper's section 4.2: the whole distance field, every pair of windows. For tests and
  /// benchmarks; slow.
  Naive,
  /// IGF-MS, the paper's approximation (section 6.1): twice the distance, by fast marching, of the
  /// nearest vertex that is a saddle of the distance field.
  Marched,
};

/// A value for every vertex, in the order of the vertices.
struct GirthField {
  /// I(v) in model units; NaN at a vertex that was not reached before the work was cancelled.
  std::vector<double> values;
  std::vector<LoopKind> kinds;
  /// Vertices computed; less than all of them only after cancelling.
  std::size_t computed{0};
  /// What it cost.
  SearchStatistics statistics;

  bool complete() const { return computed == values.size(); }
};

/// Values that were finished since the last report: value[i] and kind[i] belong to vertex[i].
struct GirthPartial {
  std::span<const Index> vertices;
  std::span<const double> values;
  std::span<const LoopKind> kinds;
};

/// I(v) for all vertices. `onPartial`, where given, is called on the calling thread every few
/// hundredths of a second with what is new, in the order of `coarseToFineOrder`, so that early
/// reports are spread over the whole surface. The same bits for any number of threads.
GirthField girthField(const SurfaceMesh& mesh, GirthMethod method = GirthMethod::Exact,
                      const ExecutionContext& context = {},
                      const std::function<void(const GirthPartial&)>& onPartial = {});

/// All vertices, ordered so that every prefix is spread evenly over the surface. O(n log n).
std::vector<Index> coarseToFineOrder(const SurfaceMesh& mesh);

}  // namespace girth
