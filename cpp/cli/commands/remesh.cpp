// girth remesh: the surface with other triangles.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/field_difference.h"
#include "girth/io/write_mesh.h"
#include "girth/remesh.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/files.h"
#include "process/report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  std::uint32_t faces{10'000};
  /// Even triangles, rather than those that keep the shape best.
  bool even{false};
  std::string output;
  /// Also compute the girth before and after, and print how far apart the two are.
  bool difference{false};
  unsigned threads{0};
  bool json{false};
};

io::Format formatOf(const std::string& extension) {
  if (extension == ".obj") return io::Format::Obj;
  if (extension == ".ply") return io::Format::Ply;
  if (extension == ".stl") return io::Format::Stl;
  if (extension == ".off") return io::Format::Off;
  return io::Format::Glb;
}

void print(const Options& options, const io::LoadedMesh& loaded, const SurfaceMesh& mesh,
           std::optional<double> difference) {
  if (options.json) {
    const std::string text =
        "{\"file\":" + io::jsonString(options.model) +
        ",\"facesBefore\":" + std::to_string(loaded.mesh.faceCount()) +
        ",\"faces\":" + std::to_string(mesh.faceCount()) +
        ",\"vertices\":" + std::to_string(mesh.vertexCount()) +
        ",\"areaBefore\":" + io::formatNumber(loaded.mesh.area()) +
        ",\"area\":" + io::formatNumber(mesh.area()) +
        ",\"meanEdgeLength\":" + io::formatNumber(mesh.meanEdgeLength()) +
        ",\"unit\":" + io::jsonString(loaded.unit) +
        ",\"output\":" + io::jsonString(options.output) +
        (difference ? ",\"difference\":" + io::formatNumber(*difference) : "") + "}\n";
    std::fputs(text.c_str(), stdout);
    return;
  }
  std::printf("%s: %u faces (before: %u), mean edge length %s%s\n", options.model.c_str(),
              mesh.faceCount(), loaded.mesh.faceCount(), readable(mesh.meanEdgeLength()).c_str(),
              unitSuffix(loaded.unit).c_str());
  std::printf("  area %s times the area before\n",
              readable(mesh.area() / loaded.mesh.area()).c_str());
  if (difference) {
    std::printf("  girth: difference %s of the distributions before and after (equation 1)\n",
                readable(*difference).c_str());
  }
}

/// How far the girth of the new surface is from that of the old one, as distributions.
Result<double> differenceOf(const Options& options, const SurfaceMesh& before,
                            const SurfaceMesh& after) {
  const auto old = computeGirth(options.model, before, options.threads);
  if (!old) return old.error();
  const auto made = computeGirth(options.model, after, options.threads);
  if (!made) return made.error();
  return fieldDifference(before, old.value().values, after, made.value().values);
}

int run(const Options& options) {
  if (auto error = checkOutput(options.output, {".obj", ".ply", ".stl", ".off", ".glb"})) {
    return reportError(options.output, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());

  const auto remeshed =
      remeshModel(options.model, loaded.value().mesh,
                  {options.faces, options.even ? RemeshMethod::Even : RemeshMethod::Fitting});
  if (!remeshed) return reportError(options.model, remeshed.error());
  const auto content = io::meshFile(remeshed.value().mesh, formatOf(extensionOf(options.output)),
                                    loaded.value().unit);
  if (!content) return reportError(options.output, content.error());
  if (auto error = writeFile(options.output, content.value())) {
    return reportError(options.output, *error);
  }
  std::optional<double> difference;
  if (options.difference) {
    const auto found = differenceOf(options, loaded.value().mesh, remeshed.value().mesh);
    if (!found) return reportError(options.model, found.error());
    difference = found.value();
  }
  print(options, loaded.value(), remeshed.value().mesh, difference);
  return 0;
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MODEL", options->model, "The model to read")->required();
  app.add_option("--faces", options->faces, "Triangles wanted; 10000 by default")
      ->check(CLI::Range(std::uint32_t{4}, kMostFaces));
  app.add_flag("--even", options->even,
               "Triangles of even size and shape, instead of those that keep the "
               "surface's shape best");
  app.add_option("-o,--output", options->output, "Write it: .obj, .ply, .stl, .off or .glb")
      ->required();
  addModelOptions(app, options->preparing);
  app.add_flag("--difference", options->difference,
               "Compute the girth before and after, and print how far apart their "
               "distributions are (equation 1 of the paper)");
  addThreadsOption(app, options->threads);
  app.add_flag("--json", options->json, "Print the summary as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kRemesh{"remesh", "Write the surface with other triangles, as many as wanted", add};

}  // namespace girth::cli
