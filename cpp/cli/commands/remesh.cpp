// girth remesh: the surface with other triangles.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/describe/remove_handles.h"
#include "girth/field_difference.h"
#include "girth/io/result_json.h"
#include "girth/io/write_mesh.h"
#include "girth/remesh.h"
#include "girth/remove_handles.h"
#include "girth/smooth_surface.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace remesh_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  /// 0: by default.
  std::uint32_t faces{0};
  /// Even triangles, rather than those that keep the shape best.
  bool even{false};
  /// Handles and tunnels with a loop shorter than this are removed, as typed. Empty: none.
  std::string removeHandles;
  /// Steps; 0: none.
  Index smoothing{0};
  Output output;
  /// Also compute the girth before and after, and print how far apart the two are.
  bool difference{false};
  unsigned threads{0};
  bool json{false};
};

void print(const Options& options, const io::LoadedMesh& loaded, const SurfaceMesh& mesh,
           const std::optional<HandleRemoval>& repaired, std::optional<double> difference) {
  if (options.json) {
    io::ResultJson json;
    json.add("file", options.model)
        .add("facesBefore", loaded.report.inputFaces)
        .add("faces", mesh.faceCount())
        .add("vertices", mesh.vertexCount())
        .add("areaBefore", loaded.mesh.area())
        .add("area", mesh.area())
        .add("meanEdgeLength", mesh.meanEdgeLength())
        .add("unit", loaded.unit)
        .add("output", options.output.path);
    if (repaired) {
      json.addMembers(*repaired).add("genus", repaired->genusAfter);
    }
    if (difference) json.add("difference", *difference);
    std::puts(json.text().c_str());
    return;
  }
  if (!hasSummary()) return;
  std::printf("%s: %u faces (before: %u), mean edge length %s%s\n", options.model.c_str(),
              mesh.faceCount(), loaded.report.inputFaces, readable(mesh.meanEdgeLength()).c_str(),
              unitSuffix(loaded.unit).c_str());
  std::printf("  area %s times the area before\n",
              readable(mesh.area() / loaded.mesh.area()).c_str());
  if (repaired) {
    const auto counted = [&](HandleKind kind, bool isDropped, const char* what, const char* done) {
      std::size_t count = 0;
      for (const RemovedHandle& one : repaired->account()) {
        count += one.kind == kind && (one.droppedArea > 0) == isDropped ? 1 : 0;
      }
      return std::to_string(count) + " " + what + (count == 1 ? " " : "s ") + done;
    };
    std::printf("  genus %u (before: %u): %s, %s, %s, %s", repaired->genusAfter,
                repaired->genusBefore,
                counted(HandleKind::Handle, true, "handle", "dropped").c_str(),
                counted(HandleKind::Handle, false, "handle", "cut").c_str(),
                counted(HandleKind::Tunnel, true, "tunnel", "filled").c_str(),
                counted(HandleKind::Tunnel, false, "tunnel", "closed").c_str());
    const std::string unknown = counted(HandleKind::Unknown, false, "loop", "of unknown kind cut");
    std::printf("%s\n", unknown[0] == '0' ? "" : (", " + unknown).c_str());
    if (repaired->crossingFaces > 0) {
      std::printf("  no room: %u of the faces made or moved cross others\n",
                  repaired->crossingFaces);
    }
  }
  if (difference) {
    std::printf("  girth: difference %s of the distributions before and after (equation 1)\n",
                readable(*difference).c_str());
  }
}

/// How far the girth of the new surface is from that of the old one, as distributions.
Result<double> differenceOf(const Options& options, const SurfaceMesh& before,
                            const SurfaceMesh& after) {
  constexpr std::string_view kRemedy = "--difference may be left out";
  const auto old = computeGirth(options.model, before, 0, options.threads, kRemedy);
  if (!old) return old.error();
  const auto made = computeGirth(options.model, after, 0, options.threads, kRemedy);
  if (!made) return made.error();
  return fieldDifference(before, old.value().values, after, made.value().values);
}

/// A wish for finer triangles, fewer handles or no wrinkles is none for fewer triangles.
Index mostFaces(const Options& options) {
  const bool isOther = !options.removeHandles.empty() || options.smoothing > 0;
  if (options.faces == 0 && isOther) return kMostFaces;
  constexpr Index kDefault = 10'000;
  return options.faces > 0 ? options.faces : std::max(kDefault, options.preparing.subdivide);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());

  std::optional<HandleRemoval> repaired;
  if (!options.removeHandles.empty()) {
    double length = 0;
    if (const auto error = readLength(options.removeHandles, loaded.value().unit, length)) {
      return reportError(options.model, *error);
    }
    auto removal = [&] {
      ProgressLine progress(options.model);
      return removeHandles(loaded.value().mesh, length, {}, watched(options.threads, progress));
    }();
    if (!removal) return reportError(options.model, removal.error());
    repaired = std::move(removal).value();
    double excess = 0;
    for (const Handle& handle : repaired->removed) {
      excess = std::max(excess, handle.mayBeShorterBy);
    }
    if (excess > 0) {
      printNote(options.model,
                "loops that were cut along may be longer than the shortest round "
                "their handles, by " +
                    readable(excess) + " at most");
    }
    if (repaired->provenLength < length) {
      printNote(options.model, "loops shorter than " + options.removeHandles +
                                   " may be left, but none shorter than " +
                                   readable(repaired->provenLength));
    }
  }
  std::optional<SurfaceMesh> smooth;
  if (options.smoothing > 0) {
    auto made = [&] {
      ProgressLine progress(options.model);
      return smoothSurface(repaired ? repaired->mesh : loaded.value().mesh, options.smoothing,
                           watched(options.threads, progress));
    }();
    if (!made) return reportError(options.model, made.error());
    smooth = std::move(made).value();
  }
  const SurfaceMesh& whole = smooth ? *smooth : repaired ? repaired->mesh : loaded.value().mesh;
  const auto remeshed =
      remeshModel(options.model, whole,
                  {mostFaces(options), options.even ? RemeshMethod::Even : RemeshMethod::Fitting});
  if (!remeshed) return reportError(options.model, remeshed.error());
  const SurfaceMesh& mesh = remeshed.value() ? remeshed.value()->mesh : whole;
  const auto content =
      io::meshFile(mesh, *io::meshFormat(options.output.ending()), loaded.value().unit);
  if (!content) return reportError(options.output.path, content.error());
  if (auto error = writeOutput(options.output, content.value())) {
    return reportError(options.output.path, *error);
  }
  std::optional<double> difference;
  if (options.difference) {
    const auto found = differenceOf(options, loaded.value().mesh, mesh);
    if (!found) return reportError(options.model, found.error());
    difference = found.value();
  }
  print(options, loaded.value(), mesh, repaired, difference);
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("--faces N", options->faces, "At most N triangles; 10000 by default")
      .range(4, kMostFaces);
  table.add("--even", options->even,
            "Triangles of even size and shape, instead of those that keep the surface's shape "
            "best");
  addSubdivideOption(table, options->preparing);
  addLengthOption(table, "--remove-handles LENGTH", options->removeHandles,
                  "Cut every handle and close every tunnel with a loop shorter than this, as in "
                  "2mm; keeps the other triangles, unless --faces is given");
  table
      .add("--smooth STEPS", options->smoothing,
           "Remove the wrinkles of a rough scan, as with 3 steps, without thinning its limbs; "
           "keeps the triangles, unless --faces is given")
      .range(0, kMostSmoothing);
  addOutputOptions(table, options->output, {".obj", ".ply", ".stl", ".off", ".glb"},
                   "Write the surface: .obj, .ply, .stl, .off or .glb")
      .required();
  addModelOptions(table, options->preparing);
  table.add("--difference", options->difference,
            "Compute the girth before and after, and print how far apart their distributions are "
            "(equation 1 of the paper)");
  addThreadsOption(table, options->threads);
  table.add("--json", options->json, "Print the summary as JSON");
  table.example("girth remesh model.glb --faces 10000 -o fewer.obj",
                "10,000 triangles that keep the shape.");
  table.example("girth remesh model.glb --subdivide 50000 -o finer.obj",
                "50,000 triangles of the same surface, where it has fewer.");
  table.example("girth remesh scan.ply --remove-handles 2mm --unit mm -o repaired.ply",
                "The surface without the handles and tunnels of noise.");
  table.example("girth remesh scan.ply --smooth 3 -o smooth.ply",
                "The surface without the wrinkles of noise.");
  table.example("girth remesh model.glb --even -o even.ply --difference",
                "Even triangles, and how much the girth changes with them.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace remesh_command

const Command kRemesh{"remesh", "Write the surface with fewer, more or even triangles, or smoother",
                      remesh_command::add};

}  // namespace girth::cli
