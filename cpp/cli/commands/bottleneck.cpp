// girth bottleneck: the narrowest place on the widest way from one point to another.
#include "girth/bottleneck.h"

#include <cstdio>
#include <memory>
#include <string>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_bottleneck.h"
#include "model/computing.h"
#include "model/typed_point.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace bottleneck_command {
namespace {

struct Options : MeasuringOptions {
  TypedPoint from, to;
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

Result<Bottleneck> compute(const Options& options, const io::LoadedMesh& loaded) {
  const auto from = surfacePoint(loaded, options.from, options.model, options.preparing);
  if (!from) return from.error();
  const auto to = surfacePoint(loaded, options.to, options.model, options.preparing);
  if (!to) return to.error();
  const auto girth = computeGirth(options.model, loaded.mesh, 0, options.threads);
  if (!girth) return girth.error();
  ProgressLine progress(options.model);
  return findBottleneck(loaded.mesh, girth.value().values, from.value(), to.value(),
                        watched(options.threads, progress));
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Bottleneck> writers{
      {{".obj", io::bottleneckObj}, {".glb", io::bottleneckGlb}},
      [options](const io::LoadedMesh& loaded, const Bottleneck& found) {
        return io::bottleneckJson(loaded, found, options->model);
      },
      [options](const io::LoadedMesh& loaded, const Bottleneck& found) {
        printText(*options, loaded, found);
      }};
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
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the loop and the way: .json, .obj or .glb (lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth bottleneck vessel.stl 120 4803 --unit mm",
                "The narrowest place on the way from one end to the other.");
  table.example("girth bottleneck model.glb 120 7:0.2,0.3,0.5 -o neck.json",
                "With the loop at the narrowest place.");
  table.note("Which way",
             "The way over the surface whose narrowest place is widest; on a ring it takes the "
             "thicker side. girth necks lists all necks.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace bottleneck_command

const Command kBottleneck{"bottleneck", "Find the narrowest place between two points",
                          bottleneck_command::add};

}  // namespace girth::cli
