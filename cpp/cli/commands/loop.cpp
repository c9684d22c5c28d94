// girth loop: the loop at one point.
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/table.h"
#include "girth/girth_field.h"
#include "girth/io/write_loop.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "model/typed_point.h"
#include "process/output.h"
#include "process/report.h"

namespace girth::cli {
namespace loop_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  TypedPoint point;
  Output output;
  /// As typed: a length or a share.
  std::string persistence;
  bool json{false};
};

void printText(const io::LoadedMesh& loaded, const GirthLoop& loop, const Options& options,
               double persistence) {
  constexpr double kDegrees = 57.29577951308232;
  const std::string unit = unitSuffix(loaded.unit);
  const Vec3 middle = positionOf(loaded.mesh, loop.midpoint);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-10s %s\n", name, value.c_str());
  };
  std::printf("%s: loop at %s%s\n", options.model.c_str(), options.point.text().c_str(),
              persistenceText(persistence, loaded).c_str());
  row("length", readable(loop.length) + unit);
  row("kind", loop.kind == LoopKind::Loop ? "loop: around the surface"
              : loop.kind == LoopKind::Antipodal
                  ? "antipodal: out to the farthest point and back"
                  : "unresolved: given up, the length is a lower bound");
  if (loop.kind == LoopKind::Unresolved) row("at most", readable(loop.atMost) + unit);
  row("angle", readable(loop.angle * kDegrees) + "°");
  row("midpoint", readable(middle.x) + " " + readable(middle.y) + " " + readable(middle.z) + unit);
  row("points", std::to_string(loop.points.size()));
}

Result<std::string> contentFor(const std::string& extension, const io::LoadedMesh& loaded,
                               const GirthLoop& loop, const std::string& model,
                               double persistence) {
  if (extension == ".json") return io::loopJson(loaded, loop, model, true, persistence);
  if (extension == ".obj") return io::loopObj(loaded, loop);
  if (extension == ".glb") return io::loopGlb(loaded, loop);
  return io::loopCsv(loaded, loop);
}

int run(const Options& options) {
  const std::string extension = options.output.ending();
  if (!options.point.vertex && !options.point.face) {
    return reportError("", usageError("no point is named", "name a vertex, or a face with --face"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto base = surfacePoint(loaded.value(), options.point, options.model, options.preparing);
  if (!base) return reportError(options.model, base.error());
  const auto persistence = persistenceOf(options.persistence, loaded.value());
  if (!persistence) return reportError("", persistence.error());
  GirthSolver solver(loaded.value().mesh);
  solver.setPersistence(persistence.value());
  const auto loop = solver.loop(base.value());
  if (!loop) return reportError(options.model, loop.error());
  if (options.output.isWanted()) {
    if (auto error = writeResult(options.output, contentFor(extension, loaded.value(), loop.value(),
                                                            options.model, persistence.value()))) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    const std::string json =
        io::loopJson(loaded.value(), loop.value(), options.model, false, persistence.value());
    std::fputs(json.c_str(), stdout);
  } else if (hasSummary()) {
    printText(loaded.value(), loop.value(), options, persistence.value());
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("VERTEX", options->point.vertex, "A vertex, numbered as in the file from 0");
  table
      .add("--face N", options->point.face,
           "A face instead, numbered from 0; polygons count as the triangles they are cut into")
      .excludes("VERTEX");
  table
      .onValue(
          "--at A,B,C",
          [options](const std::string& text) { return readWeights(text, options->point.weights); },
          "Where in the face: the shares of its three vertices; its middle by default")
      .needs("--face");
  addOutputOptions(table, options->output, {".json", ".obj", ".glb", ".csv"},
                   "Write the loop: .json, .obj or .glb (a polyline) or .csv (x,y,z)");
  addPersistenceOption(table, options->persistence);
  addModelOptions(table, options->preparing);
  table.add("--json", options->json, "Print the summary as JSON");
  table.example("girth loop model.glb 120 -o loop.obj", "The loop at vertex 120, as a polyline.");
  table.example("girth loop model.glb --face 7 --at 0.2,0.3,0.5",
                "At a point of a face, by the shares of its vertices.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace loop_command

const Command kLoop{"loop", "Compute the loop at one vertex or at a point of a face",
                    loop_command::add};

}  // namespace girth::cli
