// The cost of the persistent girth beside the girth itself, and the barcode of one point, on one
// core by processor time.
//
//   persistence [--percent P] [--vertices N] [MODEL...]
//
// tau is P per cent of the square root of the area, 2 by default. Without models: one each of
// 10,000 and 50,000 faces, the horse and the elephant of the corpus (GIRTH_DATA), otherwise bumpy
// tori. Up to N vertices of each, 2048 by default, are computed in the order of a field, the two
// ways taking turns of 32 of them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

constexpr std::size_t kTurn = 32;

void measure(const girth::bench::Model& model, double percent, std::size_t count) {
  const girth::SurfaceMesh& mesh = model.mesh;
  const double tau = percent / 100 * std::sqrt(mesh.area());
  girth::GirthSolver plain(mesh), persistent(mesh), single(mesh);
  persistent.setPersistence(tau);
  const auto order = girth::coarseToFineOrder(mesh, kTurn);
  const std::span<const girth::Vertex> vertices(order.data(), std::min(count, order.size()));
  double seconds[2]{}, windows[2]{};
  std::size_t other = 0;
  for (std::size_t begin = 0; begin < vertices.size(); begin += kTurn) {
    const auto turn = vertices.subspan(begin, std::min(kTurn, vertices.size() - begin));
    std::vector<double> values[2];
    for (const std::size_t way : {0, 1}) {
      girth::GirthSolver& solver = way == 0 ? plain : persistent;
      seconds[way] += girth::bench::processorSecondsOf([&] {
        for (const girth::Vertex v : turn) {
          const auto value = solver.value(v);
          if (!value) std::exit(1);
          values[way].push_back(value.value().length);
          windows[way] += static_cast<double>(solver.statistics().windowsCrossed);
        }
      });
    }
    for (std::size_t i = 0; i < turn.size(); ++i) other += values[0][i] != values[1][i] ? 1 : 0;
  }
  const auto share = [&](double part) { return part / static_cast<double>(vertices.size()); };
  std::printf(
      "%-22s %6u faces, %zu vertices, tau %.2g%%: %.3f ms a vertex, %.3f with it: %.2f times, %.2f "
      "times the windows; %.0f%% of the values differ\n",
      model.name.c_str(), mesh.faceCount(), vertices.size(), percent, 1e3 * share(seconds[0]),
      1e3 * share(seconds[1]), seconds[1] / seconds[0], windows[1] / windows[0],
      100 * share(static_cast<double>(other)));
  std::fflush(stdout);

  std::vector<double> milliseconds, bars;
  for (const girth::Index v : girth::bench::spreadVertices(mesh, 200)) {
    milliseconds.push_back(1e3 * girth::bench::processorSecondsOf([&] {
                             const auto barcode = single.barcode(
                                 girth::Vertex(v), {.maxPersistence = tau, .loops = true});
                             if (!barcode) std::exit(1);
                             bars.push_back(static_cast<double>(barcode.value().bars.size()));
                           }));
  }
  const auto at = [](const std::vector<double>& values, double quantile) {
    return girth::bench::quantile(values, quantile);
  };
  std::printf(
      "  barcode with loops: median %.2f ms, 95%% %.2f ms, most %.2f ms; bars: median %.0f, "
      "most %.0f\n",
      at(milliseconds, 0.5), at(milliseconds, 0.95), at(milliseconds, 1), at(bars, 0.5),
      at(bars, 1));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace girth::bench;
  std::vector<Model> models;
  double percent = 2;
  std::size_t count = 2048;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--percent" && i + 1 < argc) {
      percent = std::atof(argv[++i]);
    } else if (argument == "--vertices" && i + 1 < argc) {
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
  for (const Model& model : models) measure(model, percent, count);
}
