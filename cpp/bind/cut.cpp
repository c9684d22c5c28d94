// A surface taken apart along curves.
#include "girth/cut_surface.h"

#include <emscripten/bind.h>

#include <vector>

#include "boundary.h"
#include "girth/io/write_cut.h"
#include "girth/io/write_mesh.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A surface cut along `SurfacePoint[][]` of types.ts.
Result<CutSurface> cutAlong(const SurfaceMesh& mesh, const val& curves, bool cap) {
  std::vector<SurfaceCurve> wanted;
  for (unsigned i = 0; i < curves["length"].as<unsigned>(); ++i) {
    const val curve = curves[i];
    SurfaceCurve points;
    for (unsigned k = 0; k < curve["length"].as<unsigned>(); ++k) {
      points.push_back(pointOf(curve[k]));
    }
    wanted.push_back(std::move(points));
  }
  return cutSurface(mesh, wanted, {cap});
}

/// `CutPart` of types.ts.
val partOf(const CutSurface& whole, const SurfaceComponent& part) {
  const SurfaceMesh& mesh = part.mesh;
  std::vector<double> positions;
  std::vector<Index> vertices;
  positions.reserve(3 * std::size_t{mesh.vertexCount()});
  for (const Vertex v : mesh.vertices()) {
    const Vec3& at = mesh.position(v);
    positions.insert(positions.end(), {at.x, at.y, at.z});
    const Index inWhole = part.vertices[v];
    vertices.push_back(inWhole < whole.points.size() ? Index{whole.points[inWhole].vertex()}
                                                     : kNoIndex);
  }
  std::vector<Index> corners, faces;
  corners.reserve(3 * std::size_t{mesh.faceCount()});
  for (const Face f : mesh.faces()) {
    for (const Vertex v : mesh.faceVertices(f)) corners.push_back(v);
    faces.push_back(whole.faces[part.faces[f]]);
  }
  val result = val::object();
  result.set("positions", copyOut<double>("Float64Array", positions));
  result.set("indices", copyOut<Index>("Uint32Array", corners));
  result.set("vertices", copyOut<Index>("Uint32Array", vertices));
  result.set("faces", copyOut<Index>("Uint32Array", faces));
  result.set("area", mesh.area());
  result.set("volume", io::partVolume(mesh));
  result.set("genus", mesh.genus(0));
  result.set("boundaryCount", mesh.boundaryCount(0));
  return result;
}

/// {parts}, or an error.
val cut(const JobSurface& surface, const val& curves, bool cap) {
  return guarded([&] {
    const Result<CutSurface> whole = cutAlong(surface.mesh(), curves, cap);
    if (!whole) return toJs(whole.error());
    val parts = val::array();
    const io::CutModel model = io::cutModel(whole.value());
    for (const SurfaceComponent& part : model.parts) {
      parts.call<void>("push", partOf(whole.value(), part));
    }
    val result = val::object();
    result.set("parts", parts);
    return result;
  });
}

/// The files of a surface that was cut: one, or one for each part.
Result<std::vector<std::string>> filesOf(const io::LoadedMesh& loaded, const io::CutModel& model,
                                         const std::string& format, const std::string& name) {
  if (format == "obj") return std::vector{io::cutObj(model)};
  if (format == "json") return std::vector{io::cutJson(loaded, model, name)};
  if (format == "glb") {
    const Result<std::string> file = io::cutGlb(loaded, model);
    if (!file) return file.error();
    return std::vector{file.value()};
  }
  if (format != "stl") {
    return makeError(ErrorCode::Usage, -1, "parts are not written as '" + format + "'");
  }
  std::vector<std::string> files;
  for (const SurfaceComponent& part : model.parts) {
    Result<std::string> file = io::meshFile(part.mesh, io::Format::Stl, loaded.unit);
    if (!file) return file.error();
    files.push_back(std::move(file).value());
  }
  return files;
}

/// {files} of `WrittenModel` of protocol.ts, or an error.
val writeCut(JobSurface& surface, const val& model, const val& curves, bool cap,
             const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(model["unit"].as<std::string>());
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
