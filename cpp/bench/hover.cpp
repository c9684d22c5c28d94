// One vertex on demand: how long GirthSolver::loop takes, value and loop, through a solver that is
// warm, as when the pointer moves over the surface. The distribution over vertices.
//
//   hover [--vertices N] [MODEL...]
//
// Without models: one each of 10,000 and 50,000 faces, the horse and the elephant of the corpus
// (GIRTH_DATA), otherwise bumpy tori. 500 vertices each, evenly spread over the numbers.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

void measure(const girth::bench::Model& model, std::size_t count) {
  girth::GirthSolver solver(model.mesh);
  const std::vector<girth::Index> vertices = girth::bench::spreadVertices(model.mesh, count);
  // Warm: the memory has grown to what these vertices need.
  for (const girth::Index v : girth::bench::spreadVertices(model.mesh, 50)) {
    static_cast<void>(solver.loop(girth::Vertex(v)));
  }
  std::vector<double> milliseconds;
  std::size_t bytes = 0;
  for (const girth::Index v : vertices) {
    milliseconds.push_back(1e3 * girth::bench::secondsOf([&] {
                             if (!solver.loop(girth::Vertex(v))) std::exit(1);
                           }));
    bytes = std::max(bytes, solver.statistics().peakBytes);
  }
  const auto at = [&](double share) { return girth::bench::quantile(milliseconds, share); };
  std::printf(
      "%-22s %6u faces, %zu vertices: median %.2f ms, 95%% %.2f ms, most %.2f ms, %.0f MB\n",
      model.name.c_str(), model.mesh.faceCount(), vertices.size(), at(0.5), at(0.95), at(1),
      static_cast<double>(bytes) / 1e6);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace girth::bench;
  std::vector<Model> models;
  std::size_t count = 500;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--vertices" && i + 1 < argc) {
      count = static_cast<std::size_t>(std::atol(argv[++i]));
    } else {
      models.push_back(loadModel(argument));
    }
  }
  if (models.empty()) {
    const bool corpus = !corpusFile("").empty();
    models.push_back(corpus ? loadModel(corpusFile("retrieval/tosca_iso_5k/horse0.off"))
                            : bumpyTorus(10000));
    models.push_back(corpus ? loadModel(corpusFile("models/elephant_49918f_g3.off"))
                            : bumpyTorus(50000));
  }
  for (const Model& model : models) measure(model, count);
}
