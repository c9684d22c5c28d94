// Fields and loops as files.

#include <emscripten/bind.h>

#include <utility>

#include "boundary.h"
#include "girth/girth_solver.h"
#include "girth/io/write_field.h"
#include "girth/io/write_loop.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `WrittenModel` of wasm-modules.d.ts: a prepared surface's arrays, and what the file said.
Result<io::LoadedMesh> loadedOf(const val& model) {
  Result<SurfaceMesh> mesh = surfaceOf(model["positions"], model["indices"]);
  if (!mesh) return mesh.error();
  return io::LoadedMesh{{std::move(mesh).value(),
                         copyIn<Index>(model["vertexOfInput"]),
                         copyIn<Index>(model["inputOfVertex"]),
                         {},
                         {},
                         {}},
                        io::Format::Obj,
                        model["unit"].as<std::string>(),
                        {}};
}

val bytesOf(const std::string& content) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(content.data());
  return copyOut<std::uint8_t>("Uint8Array", {first, content.size()});
}

Result<std::string> fieldFile(const io::LoadedMesh& loaded, const io::VertexField& field,
                              const std::string& format, const std::string& name) {
  const std::span<const io::VertexField> fields(&field, 1);
  if (format == "csv") return io::fieldCsv(loaded, fields);
  if (format == "json") return io::fieldJson(loaded, fields, name);
  if (format == "npy") return io::fieldNpy(loaded, field);
  if (format == "ply") return io::fieldPly(loaded, fields);
  if (format == "glb") return io::fieldGlb(loaded, fields);
  return makeError(ErrorCode::Usage, -1, "fields are not written as '" + format + "'");
}

Result<std::string> loopFile(const io::LoadedMesh& loaded, const GirthLoop& loop,
                             const std::string& format, const std::string& name) {
  if (format == "obj") return io::loopObj(loaded, loop);
  if (format == "glb") return io::loopGlb(loaded, loop);
  if (format == "json") return io::loopJson(loaded, loop, name, true);
  return makeError(ErrorCode::Usage, -1, "loops are not written as '" + format + "'");
}

/// {bytes} of a file with the girth at every vertex, or an error.
val writeField(const val& model, const val& values, const val& kinds, const std::string& format) {
  return guarded([&] {
    const Result<io::LoadedMesh> loaded = loadedOf(model);
    if (!loaded) return toJs(loaded.error());
    GirthField girth;
    girth.values = copyIn<double>(values);
    for (const std::uint8_t kind : copyIn<std::uint8_t>(kinds)) {
      girth.kinds.push_back(static_cast<LoopKind>(kind));
    }
    const io::VertexField field =
        io::girthVertexField(girth, GirthMethod::Exact, loaded.value().unit);
    const Result<std::string> file =
        fieldFile(loaded.value(), field, format, model["name"].as<std::string>());
    if (!file) return toJs(file.error());
    val result = val::object();
    result.set("bytes", bytesOf(file.value()));
    return result;
  });
}

/// {files}, one for the loop at each of the points (vertices, or faces with weights), or an error.
val writeLoops(const val& model, const val& points, const std::string& format) {
  return guarded([&] {
    const Result<io::LoadedMesh> loaded = loadedOf(model);
    if (!loaded) return toJs(loaded.error());
    GirthSolver solver(loaded.value().mesh);
    val files = val::array();
    for (unsigned i = 0; i < points["length"].as<unsigned>(); ++i) {
      const val point = points[i];
      const val weights = point["weights"];
      const Result<GirthLoop> loop = solver.loop(
          point.isNumber() ? SurfacePoint::atVertex(point.as<Index>())
                           : SurfacePoint::inFace(point["face"].as<Index>(),
                                                  {weights[0].as<double>(), weights[1].as<double>(),
                                                   weights[2].as<double>()}));
      if (!loop) return toJs(loop.error());
      const Result<std::string> file =
          loopFile(loaded.value(), loop.value(), format, model["name"].as<std::string>());
      if (!file) return toJs(file.error());
      files.call<void>("push", bytesOf(file.value()));
    }
    val result = val::object();
    result.set("files", files);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthWrite) {
  emscripten::function("writeField", &writeField);
  emscripten::function("writeLoops", &writeLoops);
}

}  // namespace
}  // namespace girth::bind
