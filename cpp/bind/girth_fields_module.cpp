// girth-fields.mjs, the module without threads for what girth.mjs has not: the other fields, and
// what lasts of the saddles of a point.

#include <emscripten/bind.h>

#include "girth/io/vertex_field.h"
#include "pool_surface.h"

namespace girth::bind {
namespace {

/// All fields, those of persistent saddles too.
struct AllFields {
  static Result<AnyFunction> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
    return bind::functionOf(mesh, request);
  }

  /// The method of a field, as files name it; of barcodes that of the girth.
  static std::string methodOf(const FieldRequest& request) {
    return request.name == "barcode" ? std::string(io::toString(GirthMethod::Exact))
                                     : io::methodText(request.name, request.options);
  }

  /// A note on a field's values for users; so many are missing.
  static std::string noteOf(const FieldRequest& request, const SurfaceMesh& mesh,
                            Index withoutValue) {
    return fieldNote(mesh, request.name, withoutValue);
  }
};

using Surface = PoolSurface<AllFields>;

EMSCRIPTEN_BINDINGS(girthFields) {
  bindPoolSurface<Surface>()
      .function("persistentLoop", &Surface::persistentLoop)
      .function("barcode", &Surface::barcode);
}

}  // namespace
}  // namespace girth::bind
