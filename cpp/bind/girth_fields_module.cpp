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

  /// The method of a field, as files name it.
  static std::string methodOf(const FieldRequest& request) {
    if (request.name == "sdf") return io::methodText(request.shapeDiameter);
    if (request.name == "thickness") return io::methodText(request.thickness);
    if (request.name == "igf" || request.name == "angle") {
      return io::methodText(GirthOptions{GirthMethod::Exact, request.persistence});
    }
    const bool isExtent = request.name == "geoaverage" || request.name == "geofarthest";
    return std::string(io::toString(isExtent ? request.distances : DistanceMethod::Exact));
  }

  /// What a user should know of a field's values, of which so many are missing.
  static std::string noteOf(const FieldRequest& request, const SurfaceMesh& mesh,
                            Index withoutValue) {
    if (request.name == "sdf") {
      return shapeDiameterNote(isInsideOut(mesh), withoutValue, mesh.vertexCount());
    }
    if (request.name == "thickness") {
      return thicknessNote(isInsideOut(mesh), withoutValue, mesh.vertexCount());
    }
    return budgetNote(withoutValue, mesh.vertexCount());
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
