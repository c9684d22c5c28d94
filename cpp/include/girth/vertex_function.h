// Functions of the vertices of a surface, each value computed by itself: on all threads, or vertex
// by vertex where there are none.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// Computes a function at single vertices. Keeps scratch memory between calls; one for each thread.
/// Errors: VERTEX_OUT_OF_RANGE; CANCELLED.
template <class Value>
using VertexEvaluator = std::function<Result<Value>(Vertex vertex)>;

/// A function of a surface's vertices, with what all threads share of the work already done. The
/// surface must outlive it and its evaluators, which may outlive the function: one that would be
/// gone at the end of the line is refused when the program is compiled. Made by girthFunction,
/// loopAngleFunction, shapeDiameterFunction, medialThicknessFunction and geodesicExtentFunction.
/// `Value`: what it has at a vertex, such as double or GirthValue.
template <class Value>
struct VertexFunction {
  /// Makes an evaluator; may be called by several threads at once. The context serves to
  /// cancel only, and `cancel` is copied: what it points at must outlive the evaluator.
  std::function<VertexEvaluator<Value>(const ExecutionContext& context)> evaluator;
};

/// The value at vertices that were not computed.
template <class Value>
inline constexpr Value kNotComputed{};
/// The number at vertices that were not computed: NaN.
template <>
inline constexpr double kNotComputed<double> = std::numeric_limits<double>::quiet_NaN();

/// A value for every vertex, in the order of the vertices.
template <class Value>
struct VertexValues {
  /// `kNotComputed` at vertices that were not reached before the work was cancelled.
  std::vector<Value> values;
  /// Vertices computed; less than all of them only after cancelling.
  std::size_t computed{0};

  /// Whether all vertices have been computed.
  bool complete() const { return computed == values.size(); }
};

/// Values that were finished since the last report: values[i] belongs to vertices[i].
template <class Value>
struct VertexPartial {
  /// The vertices, each of them in one report only.
  std::span<const Vertex> vertices;
  /// As many values.
  std::span<const Value> values;
};

/// Works on vertices, in their order, each thread on one after the other; the calling thread is one
/// of them. `startThread` is called once on each thread,
/// and what it returns with every vertex that the thread takes; false stops that thread.
/// `onFinished`, where given, is called on the calling thread every few hundredths of a second,
/// between two vertices of its own, and at the end, with the vertices that were finished since the
/// last time; so early reports are spread over the whole surface. Returns how many vertices were
/// finished: all, unless cancelled. Exceptions are thrown again on the calling thread.
GIRTH_EXPORT std::size_t forEachVertex(
    std::vector<Vertex> vertices, const ExecutionContext& context,
    const std::function<std::function<bool(Vertex vertex)>()>& startThread,
    const std::function<void(std::span<const Vertex> vertices)>& onFinished);

/// Works on all vertices of a surface, in the order of `coarseToFineOrder`.
GIRTH_EXPORT std::size_t forEachVertex(
    const SurfaceMesh& mesh, const ExecutionContext& context,
    const std::function<std::function<bool(Vertex vertex)>()>& startThread,
    const std::function<void(std::span<const Vertex> vertices)>& onFinished);

/// The function at some vertices, by `forEachVertex`; each of them stands once in `vertices`.
/// `onPartial`, where given, has what is new. `computed` counts these vertices only. Any number of
/// threads, and any other vertices beside a vertex, give the same bits.
template <class Value>
VertexValues<Value> evaluateAt(
    const SurfaceMesh& mesh, const VertexFunction<Value>& function, std::vector<Vertex> vertices,
    const ExecutionContext& context = {},
    const std::type_identity_t<std::function<void(const VertexPartial<Value>&)>>& onPartial = {}) {
  static_assert(!std::is_same_v<Value, bool>, "threads write to neighbouring values");
  VertexValues<Value> result{{}, 0};
  std::vector<Value>& values = result.values;
  values.assign(mesh.vertexCount(), kNotComputed<Value>);
  const auto startThread = [&]() -> std::function<bool(Vertex)> {
    return [&values, evaluate = function.evaluator(context)](Vertex vertex) {
      auto value = evaluate(vertex);
      if (!value) return false;  // cancelled: the vertices are in range
      values[vertex] = std::move(value).value();
      return true;
    };
  };
  std::vector<Value> finished;
  const auto report = [&](std::span<const Vertex> some) {
    finished.clear();
    for (const Vertex vertex : some) finished.push_back(values[vertex]);
    onPartial({some, finished});
  };
  if (onPartial) {
    result.computed = forEachVertex(std::move(vertices), context, startThread, report);
  } else {
    result.computed = forEachVertex(std::move(vertices), context, startThread, {});
  }
  return result;
}

/// All vertices, ordered so that every prefix is spread evenly over the surface: first one of each
/// `run` neighbours (1 or more), then, run by run, the others. Work on neighbours, one after the
/// other, finds the surface around them still in the processor's cache. O(n log n).
GIRTH_EXPORT std::vector<Vertex> coarseToFineOrder(const SurfaceMesh& mesh, std::size_t run = 32);

/// The function at all vertices, in the order of `coarseToFineOrder`, as `evaluateAt` has it.
template <class Value>
VertexValues<Value> evaluateAll(
    const SurfaceMesh& mesh, const VertexFunction<Value>& function,
    const ExecutionContext& context = {},
    const std::type_identity_t<std::function<void(const VertexPartial<Value>&)>>& onPartial = {}) {
  return evaluateAt(mesh, function, coarseToFineOrder(mesh), context, onPartial);
}

/// A remark on values that propagations gave up (GirthSolver::setBudget), in a
/// sentence; empty where there is none.
GIRTH_EXPORT std::string budgetNote(Index withoutValue, Index vertices);

}  // namespace girth
