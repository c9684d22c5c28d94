// girth.mjs, the module without threads: here, values and loops, vertex by vertex. Each worker of a
// pool has one, and so has the worker that answers for the pointer.

#include <emscripten/bind.h>

#include <utility>

#include "boundary.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A surface and the solver that works on it.
class Surface {
 public:
  explicit Surface(SurfaceMesh mesh) : mesh_(std::move(mesh)), solver_(mesh_) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const SurfaceMesh& mesh() const { return mesh_; }

  /// I(v) for a Uint32Array of vertices: {values, kinds}, or the first error.
  val values(const val& vertices) {
    return guarded([&] {
      const std::vector<Index> wanted = copyIn<Index>(vertices);
      std::vector<double> lengths;
      std::vector<std::uint8_t> kinds;
      lengths.reserve(wanted.size());
      kinds.reserve(wanted.size());
      for (const Index vertex : wanted) {
        const Result<GirthValue> girth = solver_.value(vertex);
        if (!girth) return toJs(girth.error());
        lengths.push_back(girth.value().length);
        kinds.push_back(static_cast<std::uint8_t>(girth.value().kind));
      }
      val result = val::object();
      result.set("values", copyOut<double>("Float64Array", lengths));
      result.set("kinds", copyOut<std::uint8_t>("Uint8Array", kinds));
      return result;
    });
  }

  /// The loop at a vertex, as `FoundLoop` of wasm-modules.d.ts, or an error.
  val loopAtVertex(Index vertex) { return loop(SurfacePoint::atVertex(vertex)); }

  /// The loop at a point of a face, given by the shares of the face's vertices.
  val loopInFace(Index face, double a, double b, double c) {
    return loop(SurfacePoint::inFace(face, {a, b, c}));
  }

  /// All vertices, coarse to fine, as Uint32Array.
  val order() const {
    return guarded([&] { return copyOut<Index>("Uint32Array", coarseToFineOrder(mesh_)); });
  }

 private:
  val loop(const SurfacePoint& base) {
    return guarded([&] {
      const Result<GirthLoop> found = solver_.loop(base);
      if (!found) return toJs(found.error());
      const GirthLoop& girth = found.value();
      std::vector<float> points;
      for (const Vec3& p : polyline(mesh_, girth)) {
        points.insert(points.end(),
                      {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      }
      const Vec3 q = positionOf(mesh_, girth.midpoint);
      val midpoint = val::array();
      midpoint.set(0, q.x);
      midpoint.set(1, q.y);
      midpoint.set(2, q.z);
      val result = val::object();
      result.set("length", girth.length);
      result.set("kind", std::string(toString(girth.kind)));
      result.set("polyline", copyOut<float>("Float32Array", points));
      result.set("midpoint", midpoint);
      result.set("angle", girth.angle);
      return result;
    });
  }

  SurfaceMesh mesh_;
  GirthSolver solver_;
};

/// {surface} of a prepared surface's arrays, or an error; the surface is the caller's to delete.
val exactSurface(const val& positions, const val& indices) {
  return guarded([&] {
    Result<SurfaceMesh> mesh = surfaceOf(positions, indices);
    if (!mesh) return toJs(mesh.error());
    val result = val::object();
    result.set("surface", std::make_shared<Surface>(std::move(mesh).value()));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girth) {
  emscripten::class_<Surface>("Surface")
      .smart_ptr<std::shared_ptr<Surface>>("SurfacePointer")
      .function("values", &Surface::values)
      .function("loopAtVertex", &Surface::loopAtVertex)
      .function("loopInFace", &Surface::loopInFace)
      .function("order", &Surface::order);
  emscripten::function("exactSurface", &exactSurface);
}

}  // namespace
}  // namespace girth::bind
