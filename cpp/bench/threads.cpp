// All vertices on two threads against one: how much faster, and whether every bit is the same.
//
//   threads [MODEL...]
//
// Without models: the horse at 10,000 faces of the corpus (GIRTH_DATA), otherwise a bumpy torus.
// The fastest of three runs each, the two taking turns, so that what else the machine does touches
// both.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

void compare(const girth::bench::Model& model) {
  constexpr int kRuns = 3;
  double seconds[2];
  std::fill(seconds, seconds + 2, std::numeric_limits<double>::infinity());
  std::vector<double> values[2];
  for (int run = 0; run < kRuns; ++run) {
    for (unsigned i = 0; i < 2; ++i) {
      girth::ExecutionContext context;
      context.threads = i + 1;
      seconds[i] = std::min(
          seconds[i], girth::bench::secondsOf([&] {
            values[i] = girth::girthField(model.mesh, girth::GirthMethod::Exact, context).values;
          }));
    }
  }
  const bool same =
      values[0].size() == values[1].size() &&
      std::memcmp(values[0].data(), values[1].data(), values[0].size() * sizeof(double)) == 0;
  std::printf("%-22s %6u faces: %.3f s on one thread, %.3f s on two: %.2f times; %s\n",
              model.name.c_str(), model.mesh.faceCount(), seconds[0], seconds[1],
              seconds[0] / seconds[1], same ? "the same bits" : "DIFFERENT VALUES");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace girth::bench;
  std::vector<Model> models;
  for (int i = 1; i < argc; ++i) models.push_back(loadModel(argv[i]));
  if (models.empty()) {
    models.push_back(corpusFile("").empty()
                         ? bumpyTorus(10000)
                         : loadModel(corpusFile("retrieval/tosca_iso_5k/horse0.off")));
  }
  std::printf("%u cores\n", std::thread::hardware_concurrency());
  for (const Model& model : models) compare(model);
}
