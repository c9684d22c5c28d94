// Files with fields, loops, tips, limbs, parts and weak places.

#include <emscripten/bind.h>

#include <utility>

#include "analysis.h"
#include "boundary.h"
#include "file_content.h"
#include "girth/girth_solver.h"
#include "girth/io/write_field.h"
#include "girth/io/write_limbs.h"
#include "girth/io/write_loop.h"
#include "girth/io/write_parts.h"
#include "girth/io/write_tips.h"
#include "girth/tips.h"
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

Error unknownFormat(const char* what, const std::string& format) {
  return makeError(ErrorCode::Usage, -1,
                   std::string(what) + " are not written as '" + format + "'");
}

/// Of a `WrittenModel` of protocol.ts.
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
  return unknownFormat("loops", format);
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

/// {bytes} of a file with the tips by the girth, or an error.
val writeTips(JobSurface& surface, const val& model, const val& girth, const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    if (format != "json" && format != "obj") return toJs(unknownFormat("tips", format));
    const Result<Tips> tips = findTips(loaded.mesh, copyIn<double>(girth));
    if (!tips) return toJs(tips.error());
    return fileOf(format == "json"
                      ? io::tipsJson(loaded, tips.value(), nameOf(model), {}, persistenceOf(model))
                      : io::tipsObj(loaded, tips.value()));
  });
}

/// {bytes} of a file with the limbs by the girth, or an error.
val writeLimbs(JobSurface& surface, const val& model, const val& girth, double stations,
               const std::string& format, const val& onProgress) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    if (format != "json" && format != "csv") return toJs(unknownFormat("limbs", format));
    const Result<Limbs> limbs =
        limbsByGirth(loaded.mesh, copyIn<double>(girth), stations, reportingTo(onProgress));
    if (!limbs) return toJs(limbs.error());
    return fileOf(format == "json"
                      ? io::limbsJson(loaded, limbs.value(), nameOf(model), persistenceOf(model))
                      : io::limbsCsv(loaded, limbs.value()));
  });
}

/// {bytes} of a file with the parts, or an error.
val writeParts(JobSurface& surface, const val& model, const val& fields, const val& options,
               const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    if (format != "json") return toJs(unknownFormat("parts", format));
    const GirthAndDiameter values(fields);
    const PartOptions wanted = partOptionsOf(options);
    const Result<Parts> parts = findParts(loaded.mesh, values.girth, values.diameter, wanted);
    if (!parts) return toJs(parts.error());
    return fileOf(
        io::partsJson(loaded, parts.value(), wanted, nameOf(model), persistenceOf(model)));
  });
}

/// {bytes} of a file with the weak places, by `FileContent` of protocol.ts for its faces; or an
/// error.
val writeWeakPlaces(JobSurface& surface, const val& model, const val& content, const val& fields,
                    const val& limits, const std::string& format, const val& onProgress) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(unitOf(model));
    const WithFileContent with(surface.loaded(), content);
    if (format != "json") return toJs(unknownFormat("weak places", format));
    const PrintLimits wanted = limitsOf(limits);
    const auto check = printCheckOf(loaded.mesh, fields, wanted, reportingTo(onProgress));
    if (!check) return toJs(check.error());
    return fileOf(
        io::printCheckJson(loaded, check.value(), wanted, nameOf(model), persistenceOf(model)));
  });
}

EMSCRIPTEN_BINDINGS(girthWrite) {
  emscripten::function("writeFields", &writeFields);
  emscripten::function("writeLoops", &writeLoops);
  emscripten::function("writeTips", &writeTips);
  emscripten::function("writeLimbs", &writeLimbs);
  emscripten::function("writeParts", &writeParts);
  emscripten::function("writeWeakPlaces", &writeWeakPlaces);
}

}  // namespace
}  // namespace girth::bind
