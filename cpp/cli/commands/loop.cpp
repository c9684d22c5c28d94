// girth loop: the loop at one point.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/table.h"
#include "girth/girth_field.h"
#include "girth/io/write_loop.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/output.h"
#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  /// A vertex in the file's numbering, from 0; or a point of a face.
  std::optional<std::int64_t> vertex;
  /// A triangle in the file's order, from 0; polygons count as the triangles they are cut into.
  std::optional<std::int64_t> face;
  /// The point's shares of the face's three vertices.
  std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
  Output output;
  /// As typed: a length or a share.
  std::string persistence;
  bool json{false};
};

std::string placeText(const Options& options) {
  if (options.vertex) return "vertex " + std::to_string(*options.vertex);
  std::string text = "face " + std::to_string(*options.face) + " at ";
  for (std::size_t i = 0; i < 3; ++i) text += (i == 0 ? "" : ",") + readable(options.weights[i]);
  return text;
}

void printText(const io::LoadedMesh& loaded, const GirthLoop& loop, const Options& options,
               double persistence) {
  constexpr double kDegrees = 57.29577951308232;
  const std::string unit = unitSuffix(loaded.unit);
  const Vec3 middle = positionOf(loaded.mesh, loop.midpoint);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-10s %s\n", name, value.c_str());
  };
  std::printf("%s: loop at %s%s\n", options.model.c_str(), placeText(options).c_str(),
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

/// The shares of a face's corners as they stand on the surface, where it may have been turned over
/// since it was read.
Result<std::array<double, 3>> sharesOnSurface(const io::LoadedMesh& loaded, Index face,
                                              const Options& options) {
  if (loaded.report.reorientedFaces + loaded.report.flippedFaces == 0) return options.weights;
  const auto model = readModelFile(options.model, options.preparing.entry);
  if (!model) return model.error();
  const auto corners = loaded.mesh.faceVertices(Face(face));
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Index input =
        model.value().soup.triangles[3 * static_cast<std::size_t>(*options.face) + k];
    const Index first = loaded.inputOfVertex[loaded.vertexOfInput[input]];
    const auto corner = std::find_if(corners.begin(), corners.end(),
                                     [&](Index v) { return loaded.inputOfVertex[v] == first; });
    if (corner == corners.end()) {
      return makeError(ErrorCode::InvalidPoint, *options.face,
                       "face " + std::to_string(*options.face) +
                           " had no area and shares that of its neighbour now");
    }
    shares[static_cast<std::size_t>(corner - corners.begin())] = options.weights[k];
  }
  return shares;
}

/// The point of the surface that was asked for.
Result<SurfacePoint> basePoint(const io::LoadedMesh& loaded, const Options& options) {
  if (options.vertex) {
    const Result<Vertex> vertex = surfaceVertex(loaded, *options.vertex);
    if (!vertex) return vertex.error();
    return SurfacePoint::atVertex(vertex.value());
  }
  const Index count = loaded.report.inputFaces;
  if (*options.face < 0 || *options.face >= std::int64_t{count}) {
    Error error = makeError(ErrorCode::InvalidPoint, *options.face,
                            "there is no face " + std::to_string(*options.face));
    error.hint = "its faces are numbered from 0 to " + std::to_string(count - 1);
    return error;
  }
  const auto found = std::find(loaded.inputOfFace.begin(), loaded.inputOfFace.end(),
                               static_cast<Index>(*options.face));
  if (found == loaded.inputOfFace.end()) {
    Error error = makeError(ErrorCode::InvalidPoint, *options.face,
                            "face " + std::to_string(*options.face) + " was left out");
    error.hint = "girth info lists what was left out and why";
    return error;
  }
  const auto face = static_cast<Index>(found - loaded.inputOfFace.begin());
  const auto shares = sharesOnSurface(loaded, face, options);
  if (!shares) return shares.error();
  return SurfacePoint::inFace(Face(face), shares.value());
}

int run(const Options& options) {
  const std::string extension = options.output.ending();
  if (!options.vertex && !options.face) {
    return reportError("", usageError("no point is named", "name a vertex, or a face with --face"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto base = basePoint(loaded.value(), options);
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

/// "A,B,C": the shares of a face's three vertices.
std::string readWeights(const std::string& text, std::array<double, 3>& weights) {
  std::string rest = text + ",";
  for (double& weight : weights) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> number =
        comma == std::string::npos ? std::nullopt : io::parseNumber(rest.substr(0, comma));
    if (!number) return "\"" + text + "\" is not three numbers with commas between";
    weight = *number;
    rest.erase(0, comma + 1);
  }
  return rest.empty() ? "" : "\"" + text + "\" is more than three numbers";
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("VERTEX", options->vertex, "A vertex, numbered as in the file from 0");
  table
      .add("--face N", options->face,
           "A face instead, numbered from 0; polygons count as the triangles they are cut into")
      .excludes("VERTEX");
  table
      .onValue(
          "--at A,B,C",
          [options](const std::string& text) { return readWeights(text, options->weights); },
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

const Command kLoop{"loop", "Compute the loop at one vertex or at a point of a face", add};

}  // namespace girth::cli
