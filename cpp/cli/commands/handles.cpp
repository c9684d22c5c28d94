// girth handles: the loops round a surface's handles and through its tunnels.
#include "girth/handles.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_handles.h"
#include "model/computing.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace handles_command {
namespace {

struct Options : MeasuringOptions {
  std::optional<std::int64_t> bases;
  bool allVertices{false};
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const Handles& handles) {
  const std::size_t count = handles.handles.size(), promised = count + handles.unresolved;
  if (promised == 0) {
    std::printf("%s: no handles: its genus is 0\n", model.c_str());
    return;
  }
  std::printf("%s: genus %zu\n", model.c_str(), promised / 2);
  std::printf("  %4s %12s  %-8s %12s  %s\n", "loop", "length", "kind", "area", "centre");
  for (std::size_t i = 0; i < count; ++i) {
    const Handle& handle = handles.handles[i];
    std::printf("  %4zu %12s  %-8s %12s  %s %s %s\n", i, readable(handle.length).c_str(),
                std::string(toString(handle.kind)).c_str(), readable(handle.area).c_str(),
                readable(handle.centre.x).c_str(), readable(handle.centre.y).c_str(),
                readable(handle.centre.z).c_str());
    if (handle.mayBeShorterBy > 0) {
      std::printf("       may be shorter, by at most %s\n",
                  readable(handle.mayBeShorterBy).c_str());
    }
  }
  printUnits(loaded.unit);
}

Result<Handles> compute(const Options& options, const io::LoadedMesh& loaded) {
  HandleOptions wanted;
  if (options.bases && *options.bases < 1) {
    return usageError(std::to_string(*options.bases) + " base points are too few",
                      "give a number of at least 1");
  }
  if (options.bases) wanted.basePoints = static_cast<std::size_t>(*options.bases);
  if (options.allVertices) wanted.basePoints = loaded.mesh.vertexCount();
  ProgressLine progress(options.model);
  return findHandles(loaded.mesh, wanted, watched(options.threads, progress));
}

/// Says what is not proven, and what is missing.
void printNotes(const std::string& model, const Handles& handles) {
  const auto& all = handles.handles;
  const auto unproven = std::count_if(
      all.begin(), all.end(), [](const Handle& handle) { return handle.mayBeShorterBy > 0; });
  if (unproven > 0) {
    printNote(
        model,
        std::to_string(unproven) + " of " + std::to_string(all.size()) +
            " loops may be shorter: the proof would take longer; --all-vertices completes it");
  }
  if (handles.unresolved > 0) {
    printNote(model, std::to_string(handles.unresolved) + " handles or tunnels were not found");
  }
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Handles> writers{
      {{".csv", io::handlesCsv}, {".obj", io::handlesObj}, {".glb", io::handlesGlb}},
      [options](const io::LoadedMesh& loaded, const Handles& handles) {
        return io::handlesJson(loaded, handles, options->model);
      },
      [options](const io::LoadedMesh& loaded, const Handles& handles) {
        printText(options->model, loaded, handles);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  table.add("--base-points N", options->bases,
            "Number of points in each component whose loops are compared; 32 by default. A proof "
            "of about five seconds follows");
  table
      .add("--all-vertices", options->allVertices,
           "Compare the loops at all vertices: proven, and slow on large models")
      .excludes("--base-points");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the loops: .json, .csv (a row for each), .obj or .glb (closed lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth handles scan.ply", "The number of handles, and their sizes.");
  table.example("girth handles model.glb -o handles.glb", "The loops, as lines.");
  table.note(
      "Kinds",
      "A handle loop goes round the material and bounds a surface inside; a tunnel loop goes "
      "round a hole and bounds one outside. Unknown: the surface crosses itself so that it "
      "has no inside.");
  table.note("May be shorter",
             "Each loop is locally shortest. A proof that no shorter loop can take its place runs "
             "for about five seconds. Where time ends first, a line below a loop states how much "
             "shorter one could be at most.");
  return [options, writers] {
    return measure(
        *options,
        [&](const io::LoadedMesh& loaded) {
          auto handles = compute(*options, loaded);
          if (handles) printNotes(options->model, handles.value());
          return handles;
        },
        writers);
  };
}

}  // namespace
}  // namespace handles_command

const Command kHandles{"handles", "Find the loops round handles and tunnels", handles_command::add};

}  // namespace girth::cli
