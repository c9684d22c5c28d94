// A surface as a worker without threads holds it: values and loops, vertex by vertex. Each worker
// of a pool has an instance of its module, and so has the worker that answers for the pointer.
#pragma once

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boundary.h"
#include "described.h"
#include "girth/barcode.h"
#include "girth/describe/girth_solver.h"
#include "girth/girth_solver.h"
#include "girth/vertex_function.h"
#include "result_object.h"
#include "surface_point.h"
#include "vertex_functions.h"

namespace girth::bind {

using emscripten::val;

/// A surface, with a solver and an evaluator that are made when they are first needed. Fields, a
/// class of static functions, are those that a module has:
///   functionOf(mesh, request)           a Result of a variant of VertexFunction
///   methodOf(request)                   the method, as files name it
///   noteOf(request, mesh, withoutValue) what a user should know of the values
template <class Fields>
class PoolSurface {
 public:
  explicit PoolSurface(SurfaceMesh mesh) : mesh_(std::move(mesh)), origin_(drawingOrigin(mesh_)) {}
  PoolSurface(const PoolSurface&) = delete;
  PoolSurface& operator=(const PoolSurface&) = delete;

  /// {positions, indices}: what the surface was made from.
  val arrays() const {
    return guarded([&] { return arraysOf(mesh_); });
  }

  /// A field (`FieldRequest`) at a Uint32Array of vertices: {values, kinds}, or the first error.
  val values(const val& field, const val& vertices) {
    return guarded([&] {
      const FieldRequest request = requestOf(field);
      if (!valuesAt_ || !(request == evaluated_)) {
        valuesAt_ = nullptr;  // its memory first
        const auto function = Fields::functionOf(mesh_, request);
        if (!function) return toJs(function.error());
        valuesAt_ = std::visit(
            [&](const auto& one) -> ValuesAt { return valuesBy(one.evaluator(context_)); },
            function.value());
        evaluated_ = request;
      }
      return valuesAt_(copyIn<Index>(vertices));
    });
  }

  /// {method, note} of a field, of which so many vertices have no value.
  val about(const val& field, Index withoutValue) const {
    return guarded([&] {
      const FieldRequest request = requestOf(field);
      val result = val::object();
      result.set("method", Fields::methodOf(request));
      result.set("note", Fields::noteOf(request, mesh_, withoutValue));
      return result;
    });
  }

  /// The loop at a point, as `FoundLoop` of protocol.ts, or an error.
  val loop(const val& point) {
    return guarded([&] {
      const Result<GirthLoop> found = solver().loop(pointOf(point));
      return found ? loopOf(found.value()) : toJs(found.error());
    });
  }

  /// The loop of a persistence at a point.
  val persistentLoop(const val& point, double persistence) {
    return guarded([&] {
      solver().setPersistence(persistence);
      const val found = loop(point);
      solver().setPersistence(0);
      return found;
    });
  }

  /// The saddles of the distance from a point: {bars, loops, rest, restKind}, or an error. Births
  /// and deaths are in turn.
  val barcode(const val& point, double maxPersistence, double maxSaddles, bool withLoops) {
    constexpr double kMostSaddles = 1e9;
    return guarded([&] {
      BarcodeOptions options{maxPersistence};
      // A number that is no count becomes 0.
      const bool isCount = maxSaddles >= 0;
      if (!isCount) options.maxSaddles = 0;
      if (isCount && maxSaddles < kMostSaddles) {
        options.maxSaddles = static_cast<std::size_t>(maxSaddles);
      }
      options.loops = withLoops;
      const Result<Barcode> found = solver().barcode(pointOf(point), options);
      if (!found) return toJs(found.error());
      std::vector<double> bars;
      for (const SaddleBar& bar : found.value().bars) {
        bars.insert(bars.end(), {bar.birth, bar.death});
      }
      val loops = val::array();
      for (const GirthLoop& one : found.value().loops) loops.call<void>("push", loopOf(one));
      val result = val::object();
      result.set("bars", copyOut<double>("Float64Array", bars));
      result.set("loops", loops);
      result.set("rest", found.value().rest.length);
      result.set("restKind", std::string(toString(found.value().rest.kind)));
      return result;
    });
  }

  /// All vertices, coarse to fine, as Uint32Array.
  val order() const {
    return guarded(
        [&] { return copyOut<Index>("Uint32Array", numbersOf(coarseToFineOrder(mesh_))); });
  }

 private:
  GirthSolver& solver() {
    if (!solver_) solver_.emplace(mesh_);
    return *solver_;
  }

  /// `FoundLoop` of protocol.ts.
  val loopOf(const GirthLoop& girth) const {
    ResultObject result({&mesh_, origin_});
    visitMembers(girth, [&]<class Value>(const char* name, const Value& value) {
      if constexpr (std::is_same_v<Value, Curve>) {
        result(name, packedPoints(value.points));
        result(name, Line{value.points});
      } else {
        result(name, value);
      }
    });
    return result.object();
  }

  using ValuesAt = std::function<val(const std::vector<Index>&)>;

  template <class Evaluator>
  static ValuesAt valuesBy(Evaluator evaluate) {
    return [evaluate = std::move(evaluate)](const std::vector<Index>& wanted) {
      ValueArrays arrays;
      for (const Index vertex : wanted) {
        const auto found = evaluate(Vertex(vertex));
        if (!found) return toJs(found.error());
        arrays.add(found.value());
      }
      val result = val::object();
      arrays.setIn(result);
      return result;
    };
  }

  SurfaceMesh mesh_;
  Vec3 origin_;
  ExecutionContext context_;
  std::optional<GirthSolver> solver_;
  ValuesAt valuesAt_;
  FieldRequest evaluated_;
};

/// Binds the calls that each module has. Returns the class, for calls that one module adds.
template <class Surface>
emscripten::class_<Surface> bindPoolSurface() {
  emscripten::function("exactSurface", &exactSurface<Surface>);
  return emscripten::class_<Surface>("Surface")
      .template smart_ptr<std::shared_ptr<Surface>>("SurfacePointer")
      .function("arrays", &Surface::arrays)
      .function("values", &Surface::values)
      .function("about", &Surface::about)
      .function("loop", &Surface::loop)
      .function("order", &Surface::order);
}

}  // namespace girth::bind
