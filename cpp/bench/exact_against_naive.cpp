// The exact solver against the paper's naive algorithm (sections 4.2 and 4.3, Table I), in one run:
// time for all vertices of a bumpy torus of 500, 1,000 and 2,000 faces on one thread, and the ratio
// of the two.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "girth/girth.h"

namespace {

using girth::Index;

/// A torus whose tube swells and shrinks: `around` × `across` squares, each cut in two.
girth::SurfaceMesh bumpyTorus(Index around, Index across) {
  std::vector<double> positions;
  std::vector<Index> triangles;
  for (Index i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (Index j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across;
      const double tube = 1 + 0.3 * std::sin(3 * u) + 0.05 * std::cos(4 * v + 7 * u);
      const double rho = 4 + tube * std::cos(v);
      positions.insert(positions.end(), {rho * std::cos(u), rho * std::sin(u), tube * std::sin(v)});
      const Index in = (i + 1) % around, jn = (j + 1) % across;
      triangles.insert(triangles.end(), {i * across + j, in * across + j, in * across + jn});
      triangles.insert(triangles.end(), {i * across + j, in * across + jn, i * across + jn});
    }
  }
  return girth::SurfaceMesh::fromArrays(positions, triangles).value();
}

void allVertices(benchmark::State& state, Index around, Index across, girth::GirthMethod method) {
  const girth::SurfaceMesh mesh = bumpyTorus(around, across);
  girth::ExecutionContext context;
  context.threads = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(girth::girthField(mesh, method, context).values.data());
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
  struct Size {
    Index around, across;
  };
  const std::vector<Size> sizes = {{25, 10}, {50, 10}, {50, 20}};
  const auto nameOf = [](const Size& size, const char* method) {
    return std::string(method) + "/" + std::to_string(2 * size.around * size.across);
  };
  for (const Size& size : sizes) {
    for (const auto& [method, name] : {std::pair(girth::GirthMethod::Exact, "exact"),
                                       std::pair(girth::GirthMethod::Naive, "naive")}) {
      benchmark::RegisterBenchmark(nameOf(size, name).c_str(), [size, method = method](
                                                                   benchmark::State& state) {
        allVertices(state, size.around, size.across, method);
      })->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\nnaive / exact\n");
  for (const Size& size : sizes) {
    const auto exact = reporter.seconds.find(nameOf(size, "exact"));
    const auto naive = reporter.seconds.find(nameOf(size, "naive"));
    if (exact == reporter.seconds.end() || naive == reporter.seconds.end()) continue;
    std::printf("%6u faces: %.1f\n", 2 * size.around * size.across, naive->second / exact->second);
  }
}
