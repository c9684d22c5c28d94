// The lowest eigenpairs of the Laplace operator: processor time on one thread, and how accurate
// they are: the greatest residual |L φ − λ M φ| (in the norm of the inverse areas) against λ, and
// how far the functions are from orthonormal.
//
//   eigenpairs [--pairs N] [MODEL...]
//
// Without models: the horse at 10,000 faces of the corpus (GIRTH_DATA), otherwise a bumpy torus;
// 300 pairs. The goal is 10 s for these.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "spectral/laplacian.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

/// The greatest residual, as a share of the value (of the second value, for those that are 0).
double residualOf(const girth::SurfaceMesh& mesh, const girth::Spectrum& spectrum) {
  girth::spectral::IntrinsicTriangulation triangles(mesh);
  triangles.makeDelaunay({});
  const auto laplacian = girth::spectral::cotangentLaplacian(triangles, mesh.vertexCount());
  const std::size_t n = mesh.vertexCount();
  double worst = 0;
  for (std::size_t k = 0; k < spectrum.values.size(); ++k) {
    const double* phi = &spectrum.vectors[k * n];
    std::vector<double> rest(n, 0);
    for (const auto& [i, j, weight] : laplacian.edges) {
      rest[i] += weight * (phi[i] - phi[j]);
      rest[j] -= weight * (phi[i] - phi[j]);
    }
    double sum = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const double r = rest[v] - spectrum.values[k] * spectrum.areas[v] * phi[v];
      sum += r * r / spectrum.areas[v];
    }
    worst = std::max(worst, std::sqrt(sum) / std::max(spectrum.values[k], spectrum.values[1]));
  }
  return worst;
}

double productsOf(const girth::Spectrum& spectrum) {
  const std::size_t n = spectrum.areas.size();
  double worst = 0;
  for (std::size_t j = 0; j < spectrum.values.size(); ++j) {
    for (std::size_t k = j; k < spectrum.values.size(); ++k) {
      double product = j == k ? -1 : 0;
      for (std::size_t v = 0; v < n; ++v) {
        product += spectrum.areas[v] * spectrum.vectors[j * n + v] * spectrum.vectors[k * n + v];
      }
      worst = std::max(worst, std::fabs(product));
    }
  }
  return worst;
}

bool measure(const girth::bench::Model& model, girth::Index pairs) {
  girth::ExecutionContext context;
  context.threads = 1;
  girth::Spectrum spectrum;
  const double seconds = girth::bench::processorSecondsOf([&] {
    auto result = girth::laplaceSpectrum(model.mesh, {pairs}, context);
    if (result) spectrum = std::move(result).value();
  });
  if (spectrum.values.size() < 2) return false;
  std::printf("%-22s %6u faces, %zu pairs: %.2f s; residual %.1e, products off by %.1e\n",
              model.name.c_str(), model.mesh.faceCount(), spectrum.values.size(), seconds,
              residualOf(model.mesh, spectrum), productsOf(spectrum));
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace girth::bench;
  std::vector<Model> models;
  girth::Index pairs = 300;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--pairs" && i + 1 < argc) {
      pairs = static_cast<girth::Index>(std::atol(argv[++i]));
    } else {
      models.push_back(loadModel(argument));
    }
  }
  if (models.empty()) {
    models.push_back(corpusFile("").empty()
                         ? bumpyTorus(10000)
                         : loadModel(corpusFile("retrieval/tosca_iso_5k/horse0.off")));
  }
  for (const Model& model : models) {
    if (!measure(model, pairs)) return 1;
  }
  return 0;
}
