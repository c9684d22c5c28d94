// The exact solver against the paper's algorithm to the letter (support/ich_girth.h): processor
// time for the same vertices on one core, the ratio of the two, and at how many vertices the letter
// is wrong. Both readings of the paper (IchFilter).
//
//   exact_against_ich [--vertices N] [MODEL...]
//
// Without models: the horse at 6,000 and 10,000 faces and the elephant at 50,000 of the corpus
// (GIRTH_DATA), otherwise bumpy tori of 2,000 to 10,000 faces. All vertices up to 10,000 faces,
// every hundredth of larger models; --vertices asks for N of each.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "girth/girth.h"
#include "support/ich_girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::GirthValue;
using girth::Index;
using girth::bench::IchFilter;

/// Values of both methods that differ by more than this share are counted.
constexpr double kSame = 1e-9;

void compareWithIch(const girth::SurfaceMesh& mesh, IchFilter filter, const char* name,
                    const std::vector<Index>& vertices, const std::vector<GirthValue>& exact,
                    double exactSeconds) {
  std::vector<GirthValue> ich;
  std::size_t windows = 0;
  const double seconds = girth::bench::processorSecondsOf([&] {
    girth::bench::IchGirth solver(mesh, filter);
    for (const Index v : vertices) {
      ich.push_back(solver.value(v));
      windows += solver.windowCount();
    }
  });
  std::size_t tooShort = 0, tooLong = 0;
  double least = 1, most = 1;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    // The letter measures the farthest vertex, not the farthest point: no fault of the lemmas.
    if (exact[i].kind == girth::LoopKind::Antipodal && ich[i].kind == exact[i].kind) continue;
    const double ratio = ich[i].length / exact[i].length;
    if (std::abs(ratio - 1) <= kSame) continue;
    ++(ratio < 1 ? tooShort : tooLong);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  const double percent = 100 / static_cast<double>(vertices.size());
  std::printf("  %-28s %8.2f s, %5.2f times as long, %6zu windows a vertex;", name, seconds,
              seconds / exactSeconds, windows / vertices.size());
  std::printf(" wrong at %.1f%%: too short %.1f%% (down to %.2f), too long %.1f%% (up to %.1f)\n",
              percent * static_cast<double>(tooShort + tooLong),
              percent * static_cast<double>(tooShort), least,
              percent * static_cast<double>(tooLong), most);
}

void compare(const girth::bench::Model& model, std::size_t wanted) {
  const girth::SurfaceMesh& mesh = model.mesh;
  const std::size_t all = mesh.vertexCount();
  const std::size_t count =
      wanted > 0 ? wanted : (mesh.faceCount() <= 12000 ? all : (all + 99) / 100);
  const std::vector<Index> vertices = girth::bench::spreadVertices(mesh, count);

  std::vector<GirthValue> exact;
  std::size_t windows = 0;
  const double seconds = girth::bench::processorSecondsOf([&] {
    girth::GirthSolver solver(mesh);
    for (const Index v : vertices) {
      exact.push_back(solver.value(v).value());
      windows += solver.statistics().windowsCrossed;
    }
  });
  std::printf("%s: %u faces, %zu %svertices\n", model.name.c_str(), mesh.faceCount(),
              vertices.size(), vertices.size() < all ? "of the " : "");
  std::printf("  %-28s %8.2f s %20zu windows a vertex\n", "exact", seconds,
              windows / vertices.size());
  for (const auto& [filter, name] :
       {std::pair(IchFilter::AtCreation, "ICH, filter at creation"),
        std::pair(IchFilter::AtPropagation, "ICH, filter at propagation")}) {
    compareWithIch(mesh, filter, name, vertices, exact, seconds);
  }
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
  for (const auto& model : models) compare(model, wanted);
}
