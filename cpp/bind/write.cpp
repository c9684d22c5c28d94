// Files with the surface, with fields and with loops.

#include <emscripten/bind.h>

#include <utility>

#include "boundary.h"
#include "girth/girth_solver.h"
#include "girth/io/write_field.h"
#include "girth/io/write_loop.h"
#include "girth/io/write_mesh.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A field of JavaScript (`NamedField` of types.ts, complete) with its own memory.
struct WrittenField {
  std::string name, unit, method;
  std::vector<double> values, states;
  std::vector<LoopKind> kinds;

  explicit WrittenField(const val& field)
      : name(field["name"].as<std::string>()),
        unit(field["unit"].as<std::string>()),
        method(field["method"].as<std::string>()),
        values(copyIn<double>(field["values"])) {
    for (const std::uint8_t kind : copyIn<std::uint8_t>(field["kinds"])) {
      kinds.push_back(static_cast<LoopKind>(kind));
    }
    const auto codes = copyIn<std::uint8_t>(field["states"]);
    states.assign(codes.begin(), codes.end());
  }
  io::VertexField view() const { return {name, values, unit, method, kinds}; }
};

/// The name and the unit of a `WrittenModel` of protocol.ts.
std::string nameOf(const val& model) { return model["name"].as<std::string>(); }
std::string unitOf(const val& model) { return model["unit"].as<std::string>(); }
double persistenceOf(const val& model) { return model["persistence"].as<double>(); }

Result<std::string> loopFile(const io::LoadedMesh& loaded, const GirthLoop& loop,
                             const std::string& format, const val& model) {
  if (format == "obj") return io::loopObj(loaded, loop);
  if (format == "glb") return io::loopGlb(loaded, loop);
  if (format == "json") {
    return io::loopJson(loaded, loop, nameOf(model), true, persistenceOf(model));
  }
  return makeError(ErrorCode::Usage, -1, "loops are not written as '" + format + "'");
}

/// {bytes} of a file with fields, or an error.
val writeFields(JobSurface& surface, const val& model, const val& list, const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    std::vector<WrittenField> owned;
    for (unsigned i = 0; i < list["length"].as<unsigned>(); ++i) owned.emplace_back(list[i]);
    std::vector<io::VertexField> fields;
    for (const WrittenField& field : owned) {
      fields.push_back(field.view());
      // NumPy's files hold one field.
      if (field.states.empty() || format == "npy") continue;
      fields.push_back(io::girthStateField(field.states, field.method));
    }
    return fileOf(io::fieldFile(loaded, fields, format, nameOf(model)));
  });
}

/// {bytes} of a file with the surface alone, or an error.
val writeModel(JobSurface& surface, const val& model, const std::string& format) {
  return guarded([&]() -> val {
    const auto known = io::meshFormat("." + format);
    if (!known) {
      return toJs(makeError(ErrorCode::Usage, -1, "models are not written as '" + format + "'"));
    }
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    return fileOf(io::meshFile(loaded.mesh, *known, loaded.unit));
  });
}

/// {files}, one for the loop at each of the points (vertices, or faces with weights), or an error.
val writeLoops(JobSurface& surface, const val& model, const val& points,
               const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    GirthSolver solver(loaded.mesh);
    solver.setPersistence(persistenceOf(model));
    val files = val::array();
    for (unsigned i = 0; i < points["length"].as<unsigned>(); ++i) {
      const Result<GirthLoop> loop = solver.loop(pointOf(points[i]));
      if (!loop) return toJs(loop.error());
      const Result<std::string> file = loopFile(loaded, loop.value(), format, model);
      if (!file) return toJs(file.error());
      files.call<void>("push", fileOf(file)["bytes"]);
    }
    val result = val::object();
    result.set("files", files);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthWrite) {
  emscripten::function("writeFields", &writeFields);
  emscripten::function("writeModel", &writeModel);
  emscripten::function("writeLoops", &writeLoops);
}

}  // namespace
}  // namespace girth::bind
