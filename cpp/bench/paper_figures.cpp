// Measures of Table I and Figure 6 of the paper, for each model: seconds for all vertices and
// memory of one thread, of the exact solver and, where asked for, of the naive algorithm (paper,
// sections 4.2 and 5.1). One JSON object a line; `npm run bench:paper` makes tables and plots of
// them.
//
//   paper_figures [--threads N] [--naive-seconds S] MODEL...
//   paper_figures [--threads N] [--naive-seconds S] --refined FACES MODEL
//
// --threads: for the exact solver. Default: 1. --naive-seconds: run the naive algorithm,
// on one thread, for at most about S seconds; where that is too short for all vertices, it runs on
// a sample spread over the numbers, and "vertices" says how many: "seconds" are then extrapolated.
// --refined: the model brought to FACES triangles first (support/models.h).
//
// "bytes" is the most that was held on the heap at once beyond the mesh and the values: of the
// naive algorithm by a counting allocator, of the exact solver by its own count (SearchStatistics).

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "support/heap_meter.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::Index;

void printExact(const girth::SurfaceMesh& mesh, unsigned threads) {
  girth::ExecutionContext context;
  context.threads = threads;
  girth::GirthField field;
  const double seconds = girth::bench::secondsOf(
      [&] { field = girth::girthField(mesh, girth::GirthMethod::Exact, context); });
  std::printf(R"(,"exact":{"seconds":%.6g,"threads":%u,"bytes":%zu,"windowsPerVertex":%zu})",
              seconds, threads, field.statistics.peakBytes,
              field.statistics.windowsCrossed / std::max<std::size_t>(1, field.computed));
}

void printNaive(const girth::SurfaceMesh& mesh, double limit) {
  std::size_t bytes = 0;
  double seconds = 0;
  const auto run = [&](const std::vector<Index>& vertices) {
    for (const Index v : vertices) {
      const std::size_t before = girth::bench::heapBytes();
      girth::bench::resetHeapPeak();
      seconds += girth::bench::secondsOf([&] {
        if (!girth::study::naiveGirth(mesh, girth::Vertex(v))) std::exit(1);
      });
      bytes = std::max(bytes, girth::bench::heapPeakBytes() - before);
    }
  };
  constexpr std::size_t kTrial = 10;
  run(girth::bench::spreadVertices(mesh, kTrial));
  const double each = seconds / kTrial;
  const auto affordable = static_cast<std::size_t>(limit / each);
  const std::size_t all = mesh.vertexCount();
  const std::size_t count = std::min(all, std::max(kTrial, affordable));
  if (count > kTrial) {
    seconds = 0;
    run(girth::bench::spreadVertices(mesh, count));
  }
  std::printf(R"(,"naive":{"seconds":%.6g,"threads":1,"bytes":%zu,"vertices":%zu})",
              seconds / static_cast<double>(count) * static_cast<double>(all), bytes, count);
}

}  // namespace

int main(int argc, char** argv) {
  unsigned threads = 1;
  double naiveSeconds = 0;
  Index refinedFaces = 0;
  std::vector<std::string> paths;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads" && i + 1 < argc) {
      threads = static_cast<unsigned>(std::atoi(argv[++i]));
    } else if (argument == "--naive-seconds" && i + 1 < argc) {
      naiveSeconds = std::atof(argv[++i]);
    } else if (argument == "--refined" && i + 1 < argc) {
      refinedFaces = static_cast<Index>(std::atoi(argv[++i]));
    } else {
      paths.push_back(argument);
    }
  }
  for (const std::string& path : paths) {
    girth::bench::Model model = girth::bench::loadModel(path);
    if (refinedFaces > 0) model = girth::bench::refined(model, refinedFaces);
    std::printf(R"({"model":"%s","faces":%u,"vertices":%u)", model.name.c_str(),
                model.mesh.faceCount(), model.mesh.vertexCount());
    printExact(model.mesh, threads);
    if (naiveSeconds > 0) printNaive(model.mesh, naiveSeconds);
    std::printf("}\n");
    std::fflush(stdout);
  }
}
