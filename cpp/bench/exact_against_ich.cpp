// The exact solver against the paper's algorithm to the letter (support/ich_girth.h): processor
// time for the same vertices on one core, the ratio of the two, and at how many vertices the letter
// is wrong.
//
//   exact_against_ich [--vertices N] [MODEL...]
//
// Without models: the horse at 6,000 and 10,000 faces and the elephant at 50,000 of the corpus
// (GIRTH_DATA), otherwise bumpy tori of 2,000 to 10,000 faces. All vertices up to 10,000 faces,
// every hundredth of larger models; --vertices asks for N of each.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/ich_girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::GirthValue;
using girth::Index;

/// Values of both methods that differ by more than this share are counted.
constexpr double kSame = 1e-9;

void compare(const girth::bench::Model& model, std::size_t wanted) {
  const girth::SurfaceMesh& mesh = model.mesh;
  const std::size_t all = mesh.vertexCount();
  const std::size_t count =
      wanted > 0 ? wanted : (mesh.faceCount() <= 12000 ? all : (all + 99) / 100);
  const std::vector<Index> vertices = girth::bench::spreadVertices(mesh, count);

  std::vector<GirthValue> exact, ich;
  std::size_t exactWindows = 0, ichWindows = 0;
  const double exactSeconds = girth::bench::processorSecondsOf([&] {
    girth::GirthSolver solver(mesh);
    for (const Index v : vertices) {
      exact.push_back(solver.value(v).value());
      exactWindows += solver.statistics().windowsCrossed;
    }
  });
  const double ichSeconds = girth::bench::processorSecondsOf([&] {
    girth::bench::IchGirth solver(mesh);
    for (const Index v : vertices) {
      ich.push_back(solver.value(v));
      ichWindows += solver.windowCount();
    }
  });

  std::size_t tooShort = 0, tooLong = 0;
  double shortest = 1, longest = 1;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    // The letter measures the farthest vertex, not the farthest point: no fault of the lemmas.
    if (exact[i].kind == girth::LoopKind::Antipodal && ich[i].kind == exact[i].kind) continue;
    const double ratio = ich[i].length / exact[i].length;
    if (std::abs(ratio - 1) <= kSame) continue;
    ++(ratio < 1 ? tooShort : tooLong);
    shortest = std::min(shortest, ratio);
    longest = std::max(longest, ratio);
  }
  const auto n = static_cast<double>(vertices.size());
  std::printf("%-22s %6u %6zu%s %8.2f %8.2f %6.2f %9.0f %9.0f %6.2f%% %6.2f%% %7.3f %7.2f\n",
              model.name.c_str(), mesh.faceCount(), vertices.size(),
              vertices.size() < all ? "*" : " ", ichSeconds, exactSeconds,
              ichSeconds / exactSeconds, static_cast<double>(ichWindows) / n,
              static_cast<double>(exactWindows) / n, 100 * static_cast<double>(tooShort) / n,
              100 * static_cast<double>(tooLong) / n, shortest, longest);
  std::fflush(stdout);
}

std::vector<girth::bench::Model> defaultModels() {
  using namespace girth::bench;
  std::vector<Model> models;
  if (corpusFile("").empty()) {
    for (const Index faces : {2000u, 4000u, 6000u, 8000u, 10000u}) {
      models.push_back(bumpyTorus(faces));
    }
  } else {
    models.push_back(loadModel(corpusFile("models/horse_6000f.off")));
    models.push_back(loadModel(corpusFile("retrieval/tosca_iso_5k/horse0.off")));
    models.push_back(loadModel(corpusFile("models/elephant_49918f_g3.off")));
  }
  return models;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<girth::bench::Model> models;
  std::size_t wanted = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--vertices" && i + 1 < argc) {
      wanted = static_cast<std::size_t>(std::atol(argv[++i]));
    } else {
      models.push_back(girth::bench::loadModel(argument));
    }
  }
  if (models.empty()) models = defaultModels();
  std::printf("%-22s %6s %7s %8s %8s %6s %9s %9s %7s %7s %7s %7s\n", "model", "faces", "vertices",
              "ICH s", "exact s", "ratio", "ICH win", "exact win", "short", "long", "least",
              "most");
  for (const auto& model : models) compare(model, wanted);
  std::printf(
      "* a sample of the vertices. win: windows per vertex. short, long: vertices at which the\n"
      "letter of Lemmas 4.1 and 4.2 gives too small or too large a value; least, most: by what "
      "factor.\n");
}
