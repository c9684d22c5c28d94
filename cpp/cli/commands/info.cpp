// girth info: what a model is, and what was done to make a surface of it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/json_text.h"
#include "girth/io/report_json.h"
#include "model/loading.h"
#include "process/jobs.h"
#include "process/report.h"

namespace girth::cli {
namespace info_command {
namespace {

struct Options {
  std::vector<std::string> models;
  ModelOptions preparing;
  unsigned jobs{1};
  bool json{false};
};

struct Box {
  std::array<double, 3> low, high;
};

Box boundingBox(const SurfaceMesh& mesh) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const std::array<double, 3> position{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], position[k]);
      box.high[k] = std::max(box.high[k], position[k]);
    }
  }
  return box;
}

std::string jsonOf(const std::array<double, 3>& numbers) {
  io::JsonList list;
  for (const double number : numbers) list.add(io::numberJson(number));
  return list.text();
}

/// So many components are listed; of more the number is said.
constexpr Index kListedComponents = 10;

std::string joinedGenera(const SurfaceMesh& mesh) {
  std::string text;
  std::size_t sum = 0;
  const Index count = mesh.componentCount();
  for (Index c = 0; c < count; ++c) {
    sum += mesh.genus(c);
    if (c < kListedComponents) text += (c == 0 ? "" : ", ") + std::to_string(mesh.genus(c));
  }
  if (count <= kListedComponents) return text;
  return text + " and " + std::to_string(count - kListedComponents) + " more, " +
         std::to_string(sum) + " in all";
}

void printJson(const std::string& file, const io::LoadedMesh& loaded) {
  const SurfaceMesh& mesh = loaded.mesh;
  const Box box = boundingBox(mesh);
  io::JsonList genus, boundaries, notes, parts;
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    genus.add(std::to_string(mesh.genus(c)));
    boundaries.add(std::to_string(mesh.boundaryCount(c)));
  }
  for (const std::string& note : loaded.notes) notes.add(io::jsonString(note));
  for (const SurfacePart& part : loaded.parts) {
    parts.add(io::JsonObject().add("faces", part.faces).add("area", part.area).text());
  }
  const io::JsonObject json = io::JsonObject()
                                  .add("file", file)
                                  .add("format", io::toString(loaded.format))
                                  .add("unit", loaded.unit)
                                  .add("vertices", mesh.vertexCount())
                                  .add("edges", mesh.edgeCount())
                                  .add("faces", mesh.faceCount())
                                  .add("components", mesh.componentCount())
                                  .addJson("genus", genus.text())
                                  .addJson("boundaries", boundaries.text())
                                  .add("area", mesh.area())
                                  .add("meanEdgeLength", mesh.meanEdgeLength())
                                  .addJson("boundingBox", io::JsonObject()
                                                              .addJson("min", jsonOf(box.low))
                                                              .addJson("max", jsonOf(box.high))
                                                              .text())
                                  .addJson("notes", notes.text())
                                  .addJson("byComponent", parts.text())
                                  .addJson("report", io::reportJson(loaded.report));
  std::puts(json.text().c_str());
}

std::string counted(Index count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// The changes to the file, in words, one step a line.
std::vector<std::string> stepsDone(const PreparationReport& report, const std::string& unit) {
  std::vector<std::string> steps;
  const auto step = [&](Index count, const char* one, const char* many, const char* done) {
    if (count > 0) steps.push_back(counted(count, one, many) + " " + done);
  };
  step(report.weldedVertices, "vertex", "vertices", "welded onto another at the same place");
  step(report.degenerateFaces, "face", "faces", "without area left out");
  step(report.addedFaces, "face", "faces",
       "made by dividing others, where neighbours have a vertex within their edge");
  step(report.flippedFaces, "face", "faces", "without area merged into a neighbour");
  step(report.duplicateFaces, "face", "faces", "that were there already left out");
  step(report.unreferencedVertices, "vertex", "vertices", "that no face uses left out");
  step(report.reorientedFaces, "face", "faces", "turned over to agree with their neighbours");
  step(report.oneSidedEdges, "edge", "edges", "cut, as the surface has one side only");
  step(report.nonManifoldEdges, "edge", "edges", "with more than two faces cut apart");
  step(report.nonManifoldVertices, "vertex", "vertices", "where parts only touched cut apart");
  step(report.sliverComponents, "component", "components",
       "of less than a millionth of the largest one's area (--min-component leaves them out)");
  step(report.doubledComponents, "component", "components",
       "closed, with nothing inside: two sheets on each other");
  if (report.keptComponents < report.components) {
    steps.push_back(std::to_string(report.keptComponents) + " of " +
                    counted(report.components, "component", "components") + " kept");
  }
  for (const ClosedHole& hole : report.holes) {
    steps.push_back("a hole of " + counted(hole.edges, "edge", "edges") + ", " +
                    readable(hole.perimeter) + unit + " round, closed" +
                    (hole.vertex == kNoIndex ? "" : " at vertex " + std::to_string(hole.vertex)));
  }
  return steps;
}

void printText(const std::string& file, const io::LoadedMesh& loaded) {
  const SurfaceMesh& mesh = loaded.mesh;
  const PreparationReport& report = loaded.report;
  const Box box = boundingBox(mesh);
  const std::string unit = unitSuffix(loaded.unit);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-14s %s\n", name, value.c_str());
  };
  std::printf("%s: %s surface, %s\n", file.c_str(), report.boundaryCurves == 0 ? "closed" : "open",
              std::string(io::toString(loaded.format)).c_str());
  row("vertices", std::to_string(mesh.vertexCount()) +
                      (mesh.vertexCount() == report.inputVertices
                           ? ""
                           : " (of " + std::to_string(report.inputVertices) + " in the file)"));
  row("edges", std::to_string(mesh.edgeCount()));
  row("faces", std::to_string(mesh.faceCount()) +
                   (mesh.faceCount() == report.inputFaces
                        ? ""
                        : " (of " + std::to_string(report.inputFaces) + " in the file)"));
  row("components", std::to_string(mesh.componentCount()));
  row("genus", joinedGenera(mesh));
  if (report.boundaryCurves > 0) {
    row("boundary", counted(report.boundaryCurves, "curve", "curves") + " of " +
                        counted(report.boundaryEdges, "edge", "edges"));
  }
  row("area", readable(mesh.area()) + areaSuffix(loaded.unit));
  row("mean edge", readable(mesh.meanEdgeLength()) + unit);
  row("size", readable(box.high[0] - box.low[0]) + " × " + readable(box.high[1] - box.low[1]) +
                  " × " + readable(box.high[2] - box.low[2]) +
                  (unit.empty() ? " (unit unknown)" : unit));
  for (const std::string& note : loaded.notes) row("note", note);
  if (const std::string note = crackNote(report); !note.empty()) row("note", note);
  for (const std::string& step : stepsDone(report, unit)) row("done", step);
  if (loaded.parts.size() > 1) {
    for (std::size_t i = 0; i < std::min<std::size_t>(kListedComponents, loaded.parts.size());
         ++i) {
      row(i == 0 ? "by component" : "",
          std::to_string(i) + ": " + counted(loaded.parts[i].faces, "face", "faces") + ", area " +
              readable(loaded.parts[i].area) + areaSuffix(loaded.unit));
    }
    if (loaded.parts.size() > kListedComponents) {
      row("", "and " + std::to_string(loaded.parts.size() - kListedComponents) + " more");
    }
  }
}

int run(const Options& options) {
  return forEachJob(options.models, options.jobs, [&](std::size_t i) {
    const std::string& model = options.models[i];
    const auto loaded = loadModelWithoutNotes(model, options.preparing);
    if (!loaded) return reportError(model, loaded.error());
    if (options.json) {
      printJson(model, loaded.value());
    } else if (hasSummary()) {
      printText(model, loaded.value());
    }
    return 0;
  });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->models, "Models to read").required();
  addModelOptions(table, options->preparing);
  addJobsOption(table, options->jobs);
  table.add("--json", options->json, "Print one JSON object for each model");
  table.example("girth info model.glb", "Size, unit, components, holes, and what was repaired.");
  table.example("girth info scans/*.ply --json", "Many models, one JSON object for each.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace info_command

const Command kInfo{"info", "Describe a model, and what was repaired", info_command::add};

}  // namespace girth::cli
