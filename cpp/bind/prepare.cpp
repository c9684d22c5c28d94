// Reading and preparing surfaces: bytes or arrays in; arrays and a report out.

#include <emscripten/bind.h>

#include <optional>
#include <utility>

#include "boundary.h"
#include "described.h"
#include "file_content.h"
#include "girth/describe/prepare_surface.h"
#include "girth/io/attributes.h"
#include "girth/io/length_unit.h"
#include "girth/io/read_mesh.h"
#include "result_object.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `PrepareOptions` of types.ts; `components` is a Uint32Array.
PrepareOptions optionsOf(const val& options) {
  PrepareOptions prepare;
  prepare.scale = options["scale"].as<double>();
  prepare.weldDistance = options["weldDistance"].as<double>();
  prepare.closeHoles = options["closeHoles"].as<bool>();
  prepare.components = copyIn<Index>(options["components"]);
  prepare.minComponent = options["minComponent"].as<double>();
  return prepare;
}

/// `Prepared` of wasm-modules.d.ts, without what the file states. `corners`: what it has besides
/// the surface, as `io::cornerAttributes` gives it.
val describePrepared(const PreparedSurface& prepared,
                     const std::vector<io::Attribute>& corners = {}) {
  val parts = val::array();
  for (const SurfacePart& part : prepared.parts) {
    val entry = val::object();
    entry.set("faceCount", part.faces);
    entry.set("area", part.area);
    parts.call<void>("push", entry);
  }
  val result = describe(prepared.mesh);
  result.set("vertexOfInput", copyOut<Index>("Uint32Array", numbersOf(prepared.vertexOfInput)));
  result.set("inputOfVertex", copyOut<Index>("Uint32Array", prepared.inputOfVertex));
  result.set("parts", parts);
  result.set("report", ResultObject().addMembers(prepared.report).object());
  result.set("content", fileContentOf(prepared, corners));
  return result;
}

/// A reader that obtains the files that a model refers to from JavaScript.
io::ResourceReader readerOf(const val& resource) {
  return [resource](std::string_view name) -> std::optional<std::vector<std::byte>> {
    const val bytes = resource(std::string(name));
    if (bytes.isUndefined()) return std::nullopt;
    return copyInBytes(bytes);
  };
}

/// The model of a file's bytes (a Uint8Array). Their copy is freed before it returns.
Result<io::ReadModel> modelOf(const val& bytes, const std::string& name, const val& resource) {
  return io::readModel(copyInBytes(bytes), name, readerOf(resource), {true});
}

/// The prepared surface of a file's bytes, or an error.
val readSurface(const val& bytes, const std::string& name, const val& resource, const val& options,
                const val& onProgress) {
  return guarded([&] {
    Result<io::ReadModel> read = modelOf(bytes, name, resource);
    if (!read) return toJs(read.error());
    io::ReadModel& model = read.value();
    const PrepareOptions prepare = optionsOf(options);
    // Attributes belong to the file's triangles.
    TriangleSoup soup = model.attributes.empty() ? TriangleSoup{} : model.soup;
    const Result<PreparedSurface> prepared =
        prepareSurface(std::move(model.soup), prepare, reportingTo(onProgress));
    if (!prepared) return toJs(prepared.error());
    std::vector<io::Attribute> corners;
    if (!model.attributes.empty()) {
      corners = io::cornerAttributes(model.attributes, soup, prepare.scale, prepared.value());
      model.attributes = {};
      soup = {};
    }
    val notes = val::array();
    for (const std::string& note : model.notes) notes.call<void>("push", note);
    val result = describePrepared(prepared.value(), corners);
    result.set("format", std::string(io::toString(model.format)));
    const io::LengthUnit* unit = io::findLengthUnit(model.unit);
    result.set("unit", std::string(unit == nullptr ? "" : unit->name));
    result.set("notes", notes);
    return result;
  });
}

/// The prepared surface of a Float64Array and a Uint32Array, or an error.
val surfaceFromArrays(const val& positions, const val& indices, const val& options,
                      const val& onProgress) {
  return guarded([&] {
    TriangleSoup soup{copyIn<double>(positions), copyIn<Index>(indices)};
    const Result<PreparedSurface> prepared =
        prepareSurface(std::move(soup), optionsOf(options), reportingTo(onProgress));
    if (!prepared) return toJs(prepared.error());
    val result = describePrepared(prepared.value());
    result.set("format", std::string("arrays"));
    result.set("unit", std::string());
    result.set("notes", val::array());
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthPrepare) {
  emscripten::function("readSurface", &readSurface);
  emscripten::function("surfaceFromArrays", &surfaceFromArrays);
}

}  // namespace
}  // namespace girth::bind
