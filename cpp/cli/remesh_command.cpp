#include <cstdio>
#include <optional>

#include "commands.h"
#include "compute.h"
#include "files.h"
#include "girth/field_difference.h"
#include "girth/io/write_mesh.h"
#include "girth/remesh.h"
#include "progress_line.h"
#include "report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

io::Format formatOf(const std::string& extension) {
  if (extension == ".obj") return io::Format::Obj;
  if (extension == ".ply") return io::Format::Ply;
  if (extension == ".stl") return io::Format::Stl;
  if (extension == ".off") return io::Format::Off;
  return io::Format::Glb;
}

void print(const RemeshOptions& options, const io::LoadedMesh& loaded, const SurfaceMesh& mesh,
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
  std::printf("%s: %u faces, were %u, with edges of %s%s\n", options.model.c_str(),
              mesh.faceCount(), loaded.mesh.faceCount(), readable(mesh.meanEdgeLength()).c_str(),
              unitSuffix(loaded.unit).c_str());
  std::printf("  area %s of what it was\n", readable(mesh.area() / loaded.mesh.area()).c_str());
  if (difference) {
    std::printf("  girth %s away from what it was (equation 1)\n", readable(*difference).c_str());
  }
}

/// How far the girth of the new surface is from that of the old one, as distributions.
Result<double> differenceOf(const RemeshOptions& options, const SurfaceMesh& before,
                            const SurfaceMesh& after) {
  const auto old = computeGirth(options.model, before, options.threads);
  if (!old) return old.error();
  const auto made = computeGirth(options.model, after, options.threads);
  if (!made) return made.error();
  return fieldDifference(before, old.value().values, after, made.value().values);
}

}  // namespace

int runRemesh(const RemeshOptions& options) {
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

Result<RemeshedSurface> remeshModel(const std::string& model, const SurfaceMesh& mesh,
                                    const girth::RemeshOptions& options) {
  ProgressLine progress(model);
  const ExecutionContext context = watched(0, progress);
  return remesh(mesh, options, context);
}

}  // namespace girth::cli
