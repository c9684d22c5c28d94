// The cost of comparing shapes, on one thread: fast marching from one vertex, the distance of two
// distributions, the transport between two joint histograms, the choice of words, and a whole model
// with every group of fields.
//
//   retrieval [--benchmark_filter=...] [MODEL]
//
// Without a model: bumpy tori.

#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

#include "geodesic/fast_marching.h"
#include "girth/girth.h"
#include "girth/study/study.h"
#include "support/models.h"

namespace {

using namespace girth;
using namespace girth::study;

/// Numbers in [0, 1) that look random, always the same.
std::vector<double> numbers(std::size_t count, std::uint32_t seed) {
  std::vector<double> result(count);
  for (double& number : result) {
    seed = seed * 1664525u + 1013904223u;
    number = seed / 4294967296.0;
  }
  return result;
}

void fastMarching(benchmark::State& state) {
  const girth::SurfaceMesh mesh = girth::bench::bumpyTorus(static_cast<Index>(state.range(0))).mesh;
  const girth::geodesic::MarchingStencils stencils(mesh);
  girth::geodesic::FastMarching march(stencils);
  Index source = 0;
  for (auto _ : state) {
    double farthest = 0;
    march.run(source, [&](Index, double distance) {
      farthest = distance;
      return true;
    });
    benchmark::DoNotOptimize(farthest);
    source = (source + 97) % mesh.vertexCount();
  }
}
BENCHMARK(fastMarching)->Arg(500)->Arg(10'000)->Unit(benchmark::kMicrosecond);

void distributions(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Distribution one = distributionOf(numbers(n, 1), numbers(n, 2));
  const Distribution two = distributionOf(numbers(n, 3), numbers(n, 4));
  for (auto _ : state) benchmark::DoNotOptimize(earthMoversDistance(one, two));
}
BENCHMARK(distributions)->Arg(250)->Arg(5'000)->Unit(benchmark::kMicrosecond);

void histograms(benchmark::State& state) {
  const HistogramRange range{0, 1};
  const auto one = histogramOf(distributionOf(numbers(5'000, 1), numbers(5'000, 2)), range);
  const auto two = histogramOf(distributionOf(numbers(5'000, 3), numbers(5'000, 4)), range);
  for (auto _ : state) benchmark::DoNotOptimize(histogramDistance(one, two, range));
}
BENCHMARK(histograms)->Unit(benchmark::kMicrosecond);

void transport(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const JointHistogramOptions options{1'000, {0, 1}, {0, 1}};
  const auto one = jointHistogramOf(numbers(n, 1), numbers(n, 2), numbers(n, 3), options);
  const auto two = jointHistogramOf(numbers(n, 4), numbers(n, 5), numbers(n, 6), options);
  for (auto _ : state) benchmark::DoNotOptimize(jointDistance(one, two, 1, 1).value());
}
BENCHMARK(transport)->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMicrosecond);

void words(benchmark::State& state) {
  const auto dimensions = static_cast<std::size_t>(state.range(0));
  constexpr std::size_t kFeatures = 10'000;
  const auto features = numbers(kFeatures * dimensions, 1);
  const std::vector<double> weights(kFeatures, 1);
  girth::ExecutionContext context;
  context.threads = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        vocabularyOf(features, dimensions, weights, {48, 1, 10}, context).value().width);
  }
}
BENCHMARK(words)->Arg(19)->Arg(100)->Unit(benchmark::kMillisecond);

/// All fields of one model, as `girth retrieve` computes them.
void wholeModel(benchmark::State& state, FieldGroup group, const std::optional<std::string>& path) {
  const girth::SurfaceMesh mesh =
      path ? girth::bench::loadModel(*path).mesh : girth::bench::bumpyTorus(10'000).mesh;
  FieldParameters parameters;
  girth::ExecutionContext context;
  context.threads = 1;
  const auto surface = studySurface(mesh, parameters, context);
  if (!surface) return state.SkipWithError("the model has no surface");
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        studyFields(surface.value(), group, parameters, context).value().weights.data());
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::optional<std::string> model =
      argc > 1 ? std::optional<std::string>(argv[1]) : std::nullopt;
  for (const FieldGroup group : kFieldGroups) {
    benchmark::RegisterBenchmark(
        ("wholeModel/" + std::string(toString(group))).c_str(),
        [group, model](benchmark::State& state) { wholeModel(state, group, model); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
  benchmark::RunSpecifiedBenchmarks();
}
