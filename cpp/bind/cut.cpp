// A surface taken apart along curves.
#include "girth/cut_surface.h"

#include <emscripten/bind.h>

#include <vector>

#include "boundary.h"
#include "cut_part.h"
#include "file_content.h"
#include "girth/io/write_cut.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A surface cut along `SurfacePoint[][]` of types.ts.
Result<CutSurface> cutAlong(const SurfaceMesh& mesh, const val& curves, bool cap) {
  std::vector<SurfaceCurve> wanted;
  for (unsigned i = 0; i < curves["length"].as<unsigned>(); ++i) {
    wanted.push_back(curveOf(curves[i]));
  }
  return cutSurface(mesh, wanted, {cap});
}

/// {parts}, or an error.
val cut(const JobSurface& surface, const val& curves, bool cap) {
  return guarded([&] {
    const Result<CutSurface> whole = cutAlong(surface.mesh(), curves, cap);
    if (!whole) return toJs(whole.error());
    val parts = val::array();
    const io::CutModel model = io::cutModel(whole.value());
    for (const SurfaceComponent& part : model.parts) {
      parts.call<void>("push", cutPartOf(model, part).object());
    }
    val result = val::object();
    result.set("parts", parts);
    return result;
  });
}

/// The files of a surface that was cut: one, or one for each part.
Result<std::vector<std::string>> filesOf(const io::LoadedMesh& loaded, const io::CutModel& model,
                                         const std::string& format, const std::string& name) {
  if (format == "obj") return std::vector{io::cutObj(loaded, model)};
  if (format == "csv") return std::vector{io::cutCsv(loaded, model)};
  if (format == "json") return std::vector{io::cutJson(loaded, model, name)};
  if (format == "glb") {
    const Result<std::string> file = io::cutGlb(loaded, model);
    if (!file) return file.error();
    return std::vector{file.value()};
  }
  if (format != "stl" && format != "ply") {
    return makeError(ErrorCode::Usage, -1, "parts are not written as '" + format + "'");
  }
  const io::Format written = format == "stl" ? io::Format::Stl : io::Format::Ply;
  std::vector<std::string> files;
  for (std::size_t part = 0; part < model.parts.size(); ++part) {
    Result<std::string> file = io::partFile(loaded, model, part, written);
    if (!file) return file.error();
    files.push_back(std::move(file).value());
  }
  return files;
}

/// {files} of `WrittenModel` and `FileContent` of protocol.ts, or an error.
val writeCut(JobSurface& surface, const val& model, const val& content, const val& curves, bool cap,
             const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(model["unit"].as<std::string>());
    const WithFileContent with(surface.loaded(), content);
    const Result<CutSurface> whole = cutAlong(loaded.mesh, curves, cap);
    if (!whole) return toJs(whole.error());
    const auto files =
        filesOf(loaded, io::cutModel(whole.value()), format, model["name"].as<std::string>());
    if (!files) return toJs(files.error());
    val list = val::array();
    for (const std::string& file : files.value()) {
      list.call<void>("push", fileOf(Result<std::string>(file))["bytes"]);
    }
    val result = val::object();
    result.set("files", list);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthCut) {
  emscripten::function("cut", &cut);
  emscripten::function("writeCut", &writeCut);
}

}  // namespace
}  // namespace girth::bind
