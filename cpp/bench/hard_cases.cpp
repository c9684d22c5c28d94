// Inputs on which engines crawl: how long each takes, and how much a window, beside smooth shapes.
//
//   hard_cases [SHAPE...]     those whose name contains one of the words
//
// Values of up to 24 vertices of each, spread over the surface, on one core, by processor time.
// All other costs of a source (the vertices that it reaches, the memory that is cleared) are
// counted as windows too: one for each vertex.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include "girth/girth.h"
#include "girth/prepare_surface.h"
#include "support/hard_shapes.h"
#include "support/measure.h"

namespace {

using namespace girth;
using namespace girth::bench;

struct Measured {
  double seconds{0}, most{0};  ///< seconds of all sources, and of the one that took longest
  double windows{0};           ///< with the vertices
  Index faces{0};
  std::size_t sources{0}, unresolved{0};
  double nanoseconds() const { return 1e9 * seconds / std::max(windows, 1.0); }
};

Measured measure(const HardShape& shape) {
  auto prepared = prepareSurface(shape.soup);
  if (!prepared) {
    std::printf("%-36s %s\n", shape.name.c_str(), prepared.error().message.c_str());
    return {};
  }
  const SurfaceMesh& mesh = prepared.value().mesh;
  Measured measured;
  measured.faces = mesh.faceCount();
  GirthSolver solver(mesh);
  for (const Index v : spreadVertices(mesh, 24)) {
    const double seconds = processorSecondsOf([&] {
      const auto value = solver.value(Vertex(v));
      if (value && value.value().kind == LoopKind::Unresolved) ++measured.unresolved;
    });
    measured.seconds += seconds;
    measured.most = std::max(measured.most, seconds);
    measured.windows +=
        static_cast<double>(solver.statistics().windowsCrossed) + mesh.vertexCount();
    ++measured.sources;
  }
  return measured;
}

void print(const HardShape& shape, const Measured& m, double typical) {
  std::printf(
      "%-36s %6u faces %3zu sources %9.4f s, most %8.4f s, %8.0f windows, %7.1f ns a window",
      shape.name.c_str(), m.faces, m.sources, m.seconds, m.most,
      m.windows / static_cast<double>(std::max<std::size_t>(1, m.sources)), m.nanoseconds());
  if (typical > 0) std::printf(", %5.1f times", m.nanoseconds() / typical);
  if (m.unresolved > 0) std::printf(", %zu UNRESOLVED", m.unresolved);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<double> smooth;
  for (const HardShape& shape : smoothShapes()) {
    const Measured m = measure(shape);
    print(shape, m, 0);
    smooth.push_back(m.nanoseconds());
  }
  const double typical = quantile(smooth, 0.5);
  std::printf("median of the smooth shapes: %.1f ns a window\n", typical);
  double worst = 0;
  for (const HardShape& shape : hardShapes()) {
    const bool isChosen = argc < 2 || std::any_of(argv + 1, argv + argc, [&](const char* word) {
                            return std::strstr(shape.name.c_str(), word) != nullptr;
                          });
    if (!isChosen) continue;
    const Measured m = measure(shape);
    print(shape, m, typical);
    worst = std::max(worst, m.nanoseconds() / typical);
  }
  std::printf("the worst: %.1f times the median of the smooth shapes\n", worst);
}
