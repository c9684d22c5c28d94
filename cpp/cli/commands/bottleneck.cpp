// girth bottleneck: the narrowest place on the widest way from one point to another.
#include "girth/bottleneck.h"

#include <cstdio>
#include <memory>
#include <string>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_bottleneck.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/typed_point.h"
#include "process/hand_over.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace bottleneck_command {
namespace {

struct Options {
  std::string model;
  TypedPoint from, to;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  bool json{false};
};

void printText(const Options& options, const io::LoadedMesh& loaded, const Bottleneck& found) {
  std::printf("%s: %s\n", options.model.c_str(),
              found.kind == BottleneckKind::Neck   ? "a neck between the points"
              : found.kind == BottleneckKind::Pass ? "a narrow place between the points, no neck"
                                                   : "no neck between the points: the narrowest "
                                                     "place is one of them");
  const std::string unit = unitSuffix(loaded.unit);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-7s %s\n", name, value.c_str());
  };
  const auto place = [&](const Vec3& p) {
    return readable(p.x) + " " + readable(p.y) + " " + readable(p.z) + unit;
  };
  row("girth", readable(found.girth) + unit);
  row("place", place(positionOf(loaded.mesh, found.place)));
  if (found.points.empty()) return;
  row("centre", place(found.centre));
  row("area", readable(found.area) + areaSuffix(loaded.unit));
}

Result<std::string> contentFor(const std::string& ending, const io::LoadedMesh& loaded,
                               const Bottleneck& found, const std::string& model) {
  if (ending == ".obj") return io::bottleneckObj(loaded, found);
  if (ending == ".glb") return io::bottleneckGlb(loaded, found);
  return io::bottleneckJson(loaded, found, model);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto from = surfacePoint(loaded.value(), options.from, options.model, options.preparing);
  if (!from) return reportError(options.model, from.error());
  const auto to = surfacePoint(loaded.value(), options.to, options.model, options.preparing);
  if (!to) return reportError(options.model, to.error());
  const SurfaceMesh& mesh = loaded.value().mesh;
  const auto girth = computeGirth(options.model, mesh, 0, options.threads);
  if (!girth) return reportError(options.model, girth.error());
  const auto found = [&] {
    ProgressLine progress(options.model);
    return findBottleneck(mesh, girth.value().values, from.value(), to.value(),
                          watched(options.threads, progress));
  }();
  if (!found) return reportError(options.model, found.error());
  return handOver(
      options.output, options.json,
      [&](const std::string& ending) {
        return contentFor(ending, loaded.value(), found.value(), options.model);
      },
      [&] { return io::bottleneckJson(loaded.value(), found.value(), options.model); },
      [&] { printText(options, loaded.value(), found.value()); });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table
      .onValue(
          "FROM", [options](const std::string& text) { return readPoint(text, options->from); },
          "A vertex, numbered as in the file from 0, or a point of a face, as in 7:0.2,0.3,0.5: "
          "the shares of its three vertices")
      .required();
  table
      .onValue(
          "TO", [options](const std::string& text) { return readPoint(text, options->to); },
          "Another one")
      .required();
  addOutputOptions(table, options->output, {".json", ".obj", ".glb"},
                   "Write the loop and the way: .json, .obj or .glb (lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth bottleneck vessel.stl 120 4803 --unit mm",
                "How narrow the way from one end to the other gets.");
  table.example("girth bottleneck model.glb 120 7:0.2,0.3,0.5 -o neck.json",
                "With the loop at the narrowest place.");
  table.note("Which way",
             "Of all ways over the surface the one whose narrowest place is widest: on a ring it "
             "goes round the thicker side. girth necks lists all necks, wherever they are.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace bottleneck_command

const Command kBottleneck{"bottleneck", "Find the narrowest place between two points",
                          bottleneck_command::add};

}  // namespace girth::cli
