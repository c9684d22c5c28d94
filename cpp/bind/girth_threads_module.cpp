// girth-threads.mjs, the module with threads: whole fields, on pages that are cross-origin
// isolated.

#include <emscripten/bind.h>

#include <atomic>
#include <utility>
#include <variant>
#include <vector>

#include "boundary.h"
#include "girth/vertex_function.h"
#include "refined.h"
#include "vertex_functions.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// JavaScript sets it in another thread, through the view that `cancelFlag` returns.
std::atomic<bool> cancelled{false};
static_assert(sizeof(cancelled) == 1 && std::atomic<bool>::is_always_lock_free);

/// One byte of the shared memory: 1 stops the field that is being computed.
val cancelFlag() {
  return val(emscripten::typed_memory_view(1, reinterpret_cast<std::uint8_t*>(&cancelled)));
}

class Surface {
 public:
  explicit Surface(SurfaceMesh mesh) : mesh_(std::move(mesh)) {}

  /// A field (`FieldRequest`) at all vertices but those with a 1 in `known` (a Uint8Array, one
  /// element a vertex; empty: none is known): {complete}, or an error. Passes each value once to
  /// `onPartial({vertices, values, kinds})` while it runs. Returns early when the flag is set.
  val field(const val& wanted, const val& known, unsigned threads, const val& onPartial) const {
    return guarded([&] {
      const FieldRequest request = requestOf(wanted);
      const Result<AnyFunction> function = functionOf(mesh_, request);
      if (!function) return toJs(function.error());
      const ExecutionContext context{threads, &cancelled, {}};
      const std::vector<Vertex> vertices = verticesWithout(known);
      const bool complete = std::visit(
          [&](const auto& one) {
            const auto report = [&](const auto& partial) {
              ValueArrays arrays;
              for (const auto& value : partial.values) arrays.add(value);
              val values = val::object();
              values.set("vertices", copyOut<Index>("Uint32Array", numbersOf(partial.vertices)));
              arrays.setIn(values);
              onPartial(values);
            };
            return evaluateAt(mesh_, one, vertices, context, report).computed == vertices.size();
          },
          function.value());
      val result = val::object();
      result.set("complete", complete);
      return result;
    });
  }

  /// The refined girth: `FoundRefined` of protocol.ts, or an error; CANCELLED when the flag is set.
  val refined(const val& request, unsigned threads, const val& onProgress) const {
    return guarded([&] {
      const auto report = [onProgress](double fraction) { onProgress(fraction); };
      return refinedOf(mesh_, request, {threads, &cancelled, report});
    });
  }

 private:
  /// All vertices but those that are known, coarse to fine.
  std::vector<Vertex> verticesWithout(const val& known) const {
    std::vector<Vertex> vertices = coarseToFineOrder(mesh_);
    const auto isKnown = copyIn<std::uint8_t>(known);
    if (isKnown.size() == vertices.size()) {
      std::erase_if(vertices, [&](Vertex v) { return isKnown[v] != 0; });
    }
    return vertices;
  }

  SurfaceMesh mesh_;
};

EMSCRIPTEN_BINDINGS(girthThreads) {
  emscripten::class_<Surface>("Surface")
      .smart_ptr<std::shared_ptr<Surface>>("SurfacePointer")
      .function("field", &Surface::field)
      .function("refinedGirth", &Surface::refined);
  emscripten::function("exactSurface", &exactSurface<Surface>);
  emscripten::function("cancelFlag", &cancelFlag);
}

}  // namespace
}  // namespace girth::bind
