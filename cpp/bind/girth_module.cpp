// girth.mjs, the module without threads: values and loops, vertex by vertex. Each worker of a pool
// has an instance, and so has the worker that answers for the pointer.

#include <emscripten/bind.h>

#include <optional>
#include <utility>
#include <variant>

#include "boundary.h"
#include "described.h"
#include "girth/barcode.h"
#include "girth/girth_solver.h"
#include "girth/io/vertex_field.h"
#include "girth/vertex_function.h"
#include "surface_point.h"
#include "vertex_functions.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// The method of a field, as files name it.
std::string methodOf(const FieldRequest& request) {
  if (request.name == "sdf") return io::methodText(request.shapeDiameter);
  if (request.name == "thickness") return io::methodText(request.thickness);
  if (request.name == "igf" || request.name == "angle") {
    return io::methodText(GirthOptions{GirthMethod::Exact, request.persistence});
  }
  const bool isExtent = request.name == "geoaverage" || request.name == "geofarthest";
  return std::string(io::toString(isExtent ? request.distances : DistanceMethod::Exact));
}

/// What a user should know of a field's values, of which so many are missing.
std::string noteOf(const FieldRequest& request, const SurfaceMesh& mesh, Index withoutValue) {
  if (request.name == "sdf") {
    return shapeDiameterNote(isInsideOut(mesh), withoutValue, mesh.vertexCount());
  }
  if (request.name == "thickness") {
    return thicknessNote(isInsideOut(mesh), withoutValue, mesh.vertexCount());
  }
  return budgetNote(withoutValue, mesh.vertexCount());
}

using AnyEvaluator =
    std::variant<VertexEvaluator<GirthValue>, VertexEvaluator<double>, VertexEvaluator<Barcode>>;

/// A surface, with a solver and an evaluator that are made when they are first needed.
class Surface {
 public:
  explicit Surface(SurfaceMesh mesh) : mesh_(std::move(mesh)), origin_(drawingOrigin(mesh_)) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const SurfaceMesh& mesh() const { return mesh_; }

  /// A field (`FieldRequest`) at a Uint32Array of vertices: {values, kinds}, or the first error.
  val values(const val& field, const val& vertices) {
    return guarded([&] {
      const FieldRequest request = requestOf(field);
      if (!evaluator_ || !(request == evaluated_)) {
        evaluator_.reset();  // its memory first
        const Result<AnyFunction> function = functionOf(mesh_, request);
        if (!function) return toJs(function.error());
        evaluator_ =
            std::visit([&](const auto& one) -> AnyEvaluator { return one.evaluator(context_); },
                       function.value());
        evaluated_ = request;
      }
      const std::vector<Index> wanted = copyIn<Index>(vertices);
      return std::visit(
          [&](const auto& evaluate) {
            ValueArrays arrays;
            for (const Index vertex : wanted) {
              const auto found = evaluate(Vertex(vertex));
              if (!found) return toJs(found.error());
              arrays.add(found.value());
            }
            val result = val::object();
            arrays.setIn(result);
            return result;
          },
          *evaluator_);
    });
  }

  /// {method, note} of a field, of which so many vertices have no value.
  val about(const val& field, Index withoutValue) const {
    return guarded([&] {
      const FieldRequest request = requestOf(field);
      val result = val::object();
      result.set("method", methodOf(request));
      result.set("note", noteOf(request, mesh_, withoutValue));
      return result;
    });
  }

  /// The loop at a point, as `FoundLoop` of wasm-modules.d.ts, or an error.
  val loop(const val& point, double persistence) {
    return guarded([&] {
      solver().setPersistence(persistence);
      const Result<GirthLoop> found = solver().loop(pointOf(point));
      return found ? loopOf(found.value()) : toJs(found.error());
    });
  }

  /// The saddles of the distance from a point: {bars, loops, rest, restKind}, or an error. Births
  /// and deaths are in turn.
  val barcode(const val& point, double maxPersistence, double maxSaddles, bool withLoops) {
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
  static constexpr double kMostSaddles = 1e9;

  GirthSolver& solver() {
    if (!solver_) solver_.emplace(mesh_);
    return *solver_;
  }

  /// `FoundLoop` of wasm-modules.d.ts.
  val loopOf(const GirthLoop& girth) const {
    const Vec3 q = positionOf(mesh_, girth.midpoint);
    val result = val::object();
    result.set("length", girth.length);
    result.set("kind", std::string(toString(girth.kind)));
    result.set("points", packedPoints(girth.points));
    result.set("polyline", drawnPoints(polyline(mesh_, girth), origin_));
    result.set("midpoint", tripleOf({q.x - origin_.x, q.y - origin_.y, q.z - origin_.z}));
    result.set("angle", girth.angle);
    return result;
  }

  SurfaceMesh mesh_;
  Vec3 origin_;
  ExecutionContext context_;
  std::optional<GirthSolver> solver_;
  std::optional<AnyEvaluator> evaluator_;
  FieldRequest evaluated_;
};

EMSCRIPTEN_BINDINGS(girth) {
  emscripten::class_<Surface>("Surface")
      .smart_ptr<std::shared_ptr<Surface>>("SurfacePointer")
      .function("values", &Surface::values)
      .function("about", &Surface::about)
      .function("loop", &Surface::loop)
      .function("barcode", &Surface::barcode)
      .function("order", &Surface::order);
  emscripten::function("exactSurface", &exactSurface<Surface>);
}

}  // namespace
}  // namespace girth::bind
