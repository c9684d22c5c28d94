// Waiting times of people who work with loops: necks and handles of a model whose field is there,
// the bottleneck of two points, and a cut of the same surface in 100,000 triangles.
//
//   loops [MODEL...]
//
// Without models: a bumpy torus of 10,000 faces. Seconds by the wall clock, the fastest of three
// runs, on one thread and on two, which take turns; behind them the ratio of the latter to the time
// that the field takes on two, which depends little on the machine. The goals, on two cores and a
// model of 10,000 faces: 3 s for necks and for handles, 100 ms for a cut at 100,000.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::ExecutionContext;

constexpr int kRuns = 3;

/// Prints a line: what is measured, on one thread and on two, and beside a time to compare with.
/// Returns the time on two.
double measure(const std::string& what, double field,
               const std::function<std::string(const ExecutionContext&)>& call) {
  double seconds[2];
  std::fill(seconds, seconds + 2, std::numeric_limits<double>::infinity());
  std::string found;
  for (int run = 0; run < kRuns; ++run) {
    for (unsigned i = 0; i < 2; ++i) {
      ExecutionContext context;
      context.threads = i + 1;
      seconds[i] = std::min(seconds[i], girth::bench::secondsOf([&] { found = call(context); }));
    }
  }
  std::printf("  %-12s %8.3f s %8.3f s %7.2f  %s\n", what.c_str(), seconds[0], seconds[1],
              seconds[1] / (field > 0 ? field : seconds[1]), found.c_str());
  std::fflush(stdout);
  return seconds[1];
}

void measureModel(const girth::bench::Model& model) {
  const girth::SurfaceMesh& mesh = model.mesh;
  std::printf("%s, %u faces: one thread, two threads, beside the field\n", model.name.c_str(),
              mesh.faceCount());
  std::vector<double> girth;
  const double field = measure("field", 0, [&](const ExecutionContext& context) {
    girth = girth::girthField(mesh, girth::GirthMethod::Exact, context).values;
    return std::to_string(girth.size()) + " values";
  });
  measure("necks", field, [&](const ExecutionContext& context) {
    return std::to_string(girth::findNecks(mesh, girth, {}, context).value().necks.size());
  });
  measure("handles", field, [&](const ExecutionContext& context) {
    return std::to_string(girth::findHandles(mesh, {}, context).value().handles.size());
  });
  measure("bottleneck", field, [&](const ExecutionContext& context) {
    const auto from = girth::SurfacePoint::atVertex(girth::Vertex(0));
    const auto to = girth::SurfacePoint::atVertex(girth::Vertex(mesh.vertexCount() / 2));
    return std::string(
        toString(girth::findBottleneck(mesh, girth, from, to, context).value().kind));
  });
  const girth::bench::Model fine = girth::bench::refined(model, 100'000);
  const girth::GirthLoop loop =
      girth::girthLoop(fine.mesh, girth::Vertex(fine.mesh.vertexCount() / 2)).value();
  measure("cut at 100K", field, [&](const ExecutionContext& context) {
    const auto cut = girth::cutSurface(fine.mesh, std::span(&loop.points, 1), {}, context);
    return cut ? std::to_string(cut.value().mesh.componentCount()) + " parts" : cut.error().text();
  });
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<girth::bench::Model> models;
  for (int i = 1; i < argc; ++i) models.push_back(girth::bench::loadModel(argv[i]));
  if (models.empty()) models.push_back(girth::bench::bumpyTorus(10'000));
  for (const girth::bench::Model& model : models) measureModel(model);
}
