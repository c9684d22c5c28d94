// girth.mjs, the module without threads that is fetched first: the girth and its loops.

#include <emscripten/bind.h>

#include "girth/girth_field.h"
#include "girth/io/vertex_field.h"
#include "pool_surface.h"

namespace girth::bind {
namespace {

/// The girth, and the angle of its loops.
struct GirthFields {
  using Function = std::variant<VertexFunction<GirthValue>, VertexFunction<double>>;

  static Result<Function> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
    if (request.name == "igf") return Function(girthFunction(mesh));
    if (request.name == "angle") return Function(loopAngleFunction(mesh));
    return makeError(ErrorCode::Usage, -1, "this module has no field '" + request.name + "'");
  }
  static std::string methodOf(const FieldRequest&) {
    return std::string(io::toString(GirthMethod::Exact));
  }
  static std::string noteOf(const FieldRequest&, const SurfaceMesh& mesh, Index withoutValue) {
    return budgetNote(withoutValue, mesh.vertexCount());
  }
};

using Surface = PoolSurface<GirthFields>;

EMSCRIPTEN_BINDINGS(girth) { bindPoolSurface<Surface>(); }

}  // namespace
}  // namespace girth::bind
