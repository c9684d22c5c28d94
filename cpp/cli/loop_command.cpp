#include <cmath>
#include <cstdio>

#include "commands.h"
#include "files.h"
#include "girth/io/write_loop.h"
#include "report.h"

namespace girth::cli {
namespace {

void printText(const io::LoadedMesh& loaded, const GirthLoop& loop, const LoopOptions& options) {
  constexpr double kDegrees = 57.29577951308232;
  const std::string unit = unitSuffix(loaded.unit);
  const Vec3 middle = positionOf(loaded.mesh, loop.midpoint);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-10s %s\n", name, value.c_str());
  };
  std::printf("%s: loop at vertex %lld\n", options.model.c_str(),
              static_cast<long long>(options.vertex));
  row("length", readable(loop.length) + unit);
  row("kind", loop.kind == LoopKind::Loop ? "loop: around the surface"
              : loop.kind == LoopKind::Antipodal
                  ? "antipodal: out to the farthest point and back"
                  : "unresolved: given up, the length is a lower bound");
  row("angle", readable(loop.angle * kDegrees) + "°");
  row("midpoint", readable(middle.x) + " " + readable(middle.y) + " " + readable(middle.z) + unit);
  row("points", std::to_string(loop.points.size()));
}

std::string contentFor(const std::string& extension, const io::LoadedMesh& loaded,
                       const GirthLoop& loop, const std::string& model) {
  if (extension == ".json") return io::loopJson(loaded, loop, model, true);
  if (extension == ".obj") return io::loopObj(loaded, loop);
  return io::loopCsv(loaded, loop);
}

/// The vertex of the surface that a number of the file means.
Result<Index> surfaceVertex(const io::LoadedMesh& loaded, std::int64_t vertex) {
  const std::size_t count = loaded.vertexOfInput.size();
  if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= count) {
    Error error = makeError(ErrorCode::VertexOutOfRange, vertex,
                            "there is no vertex " + std::to_string(vertex));
    error.hint = "its vertices are numbered from 0 to " + std::to_string(count - 1);
    return error;
  }
  const Index found = loaded.vertexOfInput[static_cast<std::size_t>(vertex)];
  if (found == kNoIndex) {
    Error error = makeError(ErrorCode::VertexOutOfRange, vertex,
                            "no face uses vertex " + std::to_string(vertex));
    error.hint = "name a vertex of a face";
    return error;
  }
  return found;
}

}  // namespace

int runLoop(const LoopOptions& options) {
  const std::string extension = extensionOf(options.output);
  if (!options.output.empty()) {
    if (extension != ".json" && extension != ".obj" && extension != ".csv") {
      Error error = makeError(ErrorCode::Usage, -1, "the output's name has no known ending");
      error.hint = "use .json, .obj or .csv";
      return reportError(options.output, error);
    }
    if (auto error = checkWritable(options.output)) return reportError(options.output, *error);
  }
  const auto loaded = loadModel(options.model);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto vertex = surfaceVertex(loaded.value(), options.vertex);
  if (!vertex) return reportError(options.model, vertex.error());
  const auto loop = girthLoop(loaded.value().mesh, vertex.value());
  if (!loop) return reportError(options.model, loop.error());
  if (!options.output.empty()) {
    const auto content = contentFor(extension, loaded.value(), loop.value(), options.model);
    if (auto error = writeFile(options.output, content)) {
      return reportError(options.output, *error);
    }
  }
  if (options.json) {
    std::fputs(io::loopJson(loaded.value(), loop.value(), options.model, false).c_str(), stdout);
  } else {
    printText(loaded.value(), loop.value(), options);
  }
  return 0;
}

}  // namespace girth::cli
