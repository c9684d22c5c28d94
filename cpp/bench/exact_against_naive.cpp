// The exact solver against the paper's naive algorithm (sections 4.2 and 4.3, Table I), in one run:
// time for all vertices of a bumpy torus of 500, 1,000 and 2,000 faces on one thread, and the ratio
// of the two.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "support/models.h"

namespace {

using girth::Index;

void allVertices(benchmark::State& state, Index faces, bool naive) {
  const girth::SurfaceMesh mesh = girth::bench::bumpyTorus(faces).mesh;
  girth::ExecutionContext context;
  context.threads = 1;
  for (auto _ : state) {
    const girth::GirthField field =
        naive ? girth::study::naiveGirthField(mesh, context)
              : girth::girthField(mesh, girth::GirthMethod::Exact, context);
    benchmark::DoNotOptimize(field.values.data());
  }
  state.counters["faces"] = mesh.faceCount();
}

/// The usual table, and the seconds of each run to form ratios from.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      seconds[run.benchmark_name()] =
          run.real_accumulated_time / static_cast<double>(run.iterations);
  }
  std::map<std::string, double> seconds;
};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Index> sizes = {500, 1000, 2000};
  const auto nameOf = [](Index faces, const char* method) {
    return std::string(method) + "/" + std::to_string(faces);
  };
  for (const Index faces : sizes) {
    for (const bool isNaive : {false, true}) {
      benchmark::RegisterBenchmark(
          nameOf(faces, isNaive ? "naive" : "exact").c_str(),
          [faces, isNaive](benchmark::State& state) { allVertices(state, faces, isNaive); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\nnaive / exact\n");
  for (const Index faces : sizes) {
    const auto exact = reporter.seconds.find(nameOf(faces, "exact"));
    const auto naive = reporter.seconds.find(nameOf(faces, "naive"));
    if (exact == reporter.seconds.end() || naive == reporter.seconds.end()) continue;
    std::printf("%6u faces: %.1f\n", faces, naive->second / exact->second);
  }
}
