// Functions of the vertices of a surface, each value computed by itself: on all threads, or vertex
// by vertex where there are none.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The value of a function at a vertex.
struct VertexValue {
  /// NaN where the function has none.
  double value{0};
  /// Of the girth: how it came about. Of other functions, Loop.
  LoopKind kind{LoopKind::Loop};
};

/// Computes a function at single vertices. Keeps scratch memory between calls; one for each thread.
/// Errors: VERTEX_OUT_OF_RANGE; CANCELLED.
using VertexEvaluator = std::function<Result<VertexValue>(Index vertex)>;

/// A function of a surface's vertices, with what all threads share of the work already done. The
/// surface must outlive it; evaluators may outlive it. Made by girthFunction, loopAngleFunction,
/// shapeDiameterFunction and geodesicExtentFunction.
struct VertexFunction {
  /// Makes an evaluator; may be called by several threads at once. Of the context, which must
  /// outlive the evaluator, only `cancel` matters.
  std::function<VertexEvaluator(const ExecutionContext& context)> evaluator;
};

/// A value for every vertex, in the order of the vertices.
struct VertexValues {
  /// NaN where the function has none, and at vertices that were not reached before the work was
  /// cancelled.
  std::vector<double> values;
  std::vector<LoopKind> kinds;
  /// Vertices computed; less than all of them only after cancelling.
  std::size_t computed{0};

  bool complete() const { return computed == values.size(); }
};

/// Values that were finished since the last report: value[i] and kind[i] belong to vertex[i].
struct VertexPartial {
  std::span<const Index> vertices;
  std::span<const double> values;
  std::span<const LoopKind> kinds;
};

/// The function at all vertices. The calling thread is one of those that compute. `onPartial`,
/// where given, is called on it every few hundredths of a second, between two vertices of its own,
/// with what is new, in the order of `coarseToFineOrder`, so that early reports are spread over the
/// whole surface. The same bits for any number of threads.
VertexValues evaluateAll(const SurfaceMesh& mesh, const VertexFunction& function,
                         const ExecutionContext& context = {},
                         const std::function<void(const VertexPartial&)>& onPartial = {});

/// What people are to know of values that propagations gave up (GirthSolver::setBudget), in a
/// sentence; empty where there is none.
std::string budgetNote(Index withoutValue, Index vertices);

/// All vertices, ordered so that every prefix is spread evenly over the surface: first one of each
/// `run` neighbours (1 or more), then, run by run, the others. Work on neighbours, one after the
/// other, finds the surface around them still in the processor's cache. O(n log n).
std::vector<Index> coarseToFineOrder(const SurfaceMesh& mesh, std::size_t run = 32);

}  // namespace girth
