// girth handles: the loops round a surface's handles and through its tunnels.
#include "girth/handles.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_handles.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/hand_over.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace handles_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  std::optional<std::int64_t> bases;
  bool allVertices{false};
  bool json{false};
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
    std::printf("  %4zu %12s  %-8s %12s  %s %s %s\n", i + 1, readable(handle.length).c_str(),
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

Result<std::string> contentFor(const std::string& ending, const io::LoadedMesh& loaded,
                               const Handles& handles, const std::string& model) {
  if (ending == ".csv") return io::handlesCsv(loaded, handles);
  if (ending == ".obj") return io::handlesObj(loaded, handles);
  if (ending == ".glb") return io::handlesGlb(loaded, handles);
  return io::handlesJson(loaded, handles, model);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  HandleOptions wanted;
  if (options.bases && *options.bases < 1) {
    return reportError("", usageError(std::to_string(*options.bases) + " base points are too few",
                                      "give a number of at least 1"));
  }
  if (options.bases) wanted.basePoints = static_cast<std::size_t>(*options.bases);
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  if (options.allVertices) wanted.basePoints = loaded.value().mesh.vertexCount();
  const auto handles = [&] {
    ProgressLine progress(options.model);
    return findHandles(loaded.value().mesh, wanted, watched(options.threads, progress));
  }();
  if (!handles) return reportError(options.model, handles.error());
  const auto& all = handles.value().handles;
  const auto unproven = std::count_if(
      all.begin(), all.end(), [](const Handle& handle) { return handle.mayBeShorterBy > 0; });
  if (unproven > 0) {
    printNote(options.model,
              std::to_string(unproven) + " of " + std::to_string(all.size()) +
                  " loops may be shorter: the proof would take longer; --all-vertices makes it");
  }
  if (handles.value().unresolved > 0) {
    printNote(options.model,
              std::to_string(handles.value().unresolved) + " handles or tunnels were not found");
  }
  return handOver(
      options.output, options.json,
      [&](const std::string& ending) {
        return contentFor(ending, loaded.value(), handles.value(), options.model);
      },
      [&] { return io::handlesJson(loaded.value(), handles.value(), options.model); },
      [&] { printText(options.model, loaded.value(), handles.value()); });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("--base-points N", options->bases,
            "Points of each component whose loops are compared at first; 32 by default. Then loops "
            "are proven shortest, for about five seconds");
  table
      .add("--all-vertices", options->allVertices,
           "Compare the loops at all vertices: proven, and slow on large models")
      .excludes("--base-points");
  addOutputOptions(table, options->output, {".json", ".csv", ".obj", ".glb"},
                   "Write the loops: .json, .csv (a row for each), .obj or .glb (closed lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth handles scan.ply", "How many handles it has, and how small they are.");
  table.example("girth handles model.glb -o handles.glb", "Their loops, as lines to look at.");
  table.note(
      "Kinds",
      "A handle loop goes round the material and bounds a surface inside; a tunnel loop goes "
      "round a hole and bounds one outside. Unknown: the surface crosses itself so that it "
      "has no inside.");
  table.note(
      "May be shorter",
      "Each loop is locally shortest, and is proven to be the shortest of those that could "
      "take its place, as far as the time goes. Where it ends first, a line below says by how "
      "much a shorter one could be shorter at most.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace handles_command

const Command kHandles{"handles", "Find the loops round handles and tunnels", handles_command::add};

}  // namespace girth::cli
