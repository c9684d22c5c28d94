// The girth at all vertices by the refined method, in bands round loops, against the exact one: how
// much sooner, and at how many vertices it is the same. On one core by processor time.
//
//   refined [--vertices N] [MODEL...]
//
// Without models: those of five sizes, of the corpus (GIRTH_DATA) or made here. The exact method
// computes N vertices, 1000 by default, drawn at random; its time for all is in proportion. The
// refined method's audit is left out of its time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

void measure(const girth::bench::Model& model, std::size_t count) {
  const girth::SurfaceMesh& mesh = model.mesh;
  girth::ExecutionContext context;
  context.threads = 1;
  girth::RefinedOptions options;
  options.audit = 0;
  girth::RefinedGirth refined;
  const double refinedSeconds = girth::bench::processorSecondsOf([&] {
    auto result = girth::refinedGirth(mesh, options, context);
    if (!result) std::exit(1);
    refined = std::move(result).value();
  });

  // At random: the method itself looks at vertices that are evenly spread.
  std::vector<girth::Vertex> sample;
  for (const girth::Vertex v : mesh.vertices()) sample.push_back(v);
  std::shuffle(sample.begin(), sample.end(), std::mt19937_64(2));
  sample.resize(std::min(count, sample.size()));
  girth::GirthSolver solver(mesh);
  std::size_t equal = 0, far = 0, shorter = 0;
  std::vector<double> differences;
  const double sampleSeconds = girth::bench::processorSecondsOf([&] {
    for (const girth::Vertex v : sample) {
      const auto exact = solver.value(v);
      if (!exact) std::exit(1);
      const double difference = refined.field.values[v] / exact.value().length - 1;
      equal += std::fabs(difference) <= 1e-6 ? 1 : 0;
      far += std::fabs(difference) <= 0.01 ? 0 : 1;
      shorter += difference < -1e-6 ? 1 : 0;
      differences.push_back(std::isnan(difference) ? 1 : std::fabs(difference));
    }
  });
  const auto percent = [&](std::size_t part) {
    return 100 * static_cast<double>(part) / static_cast<double>(sample.size());
  };
  const double exactSeconds =
      sampleSeconds * mesh.vertexCount() / static_cast<double>(sample.size());
  std::printf(
      "%-22s %7u faces: exact %.1f s, refined %.1f s, %.1f times sooner; of %zu vertices %.2f%% "
      "equal, %.2f%% off by over 1%% (%.2f%% too short), at most %.2g; %u suspect of %u\n",
      model.name.c_str(), mesh.faceCount(), exactSeconds, refinedSeconds,
      exactSeconds / refinedSeconds, sample.size(), percent(equal), percent(far), percent(shorter),
      *std::max_element(differences.begin(), differences.end()),
      refined.count(girth::GirthState::Suspect), mesh.vertexCount());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 1000;
  std::vector<girth::bench::Model> models;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--vertices" && i + 1 < argc) {
      count = std::strtoul(argv[++i], nullptr, 10);
    } else {
      models.push_back(girth::bench::loadModel(argument));
    }
  }
  if (models.empty()) models = girth::bench::modelsOfFiveSizes();
  for (const girth::bench::Model& model : models) measure(model, std::max<std::size_t>(1, count));
  return 0;
}
