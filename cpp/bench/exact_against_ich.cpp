// The exact solver against the paper's algorithm to the letter (support/ich_girth.h): processor
// time for the same vertices on one core, the ratio of the two, and at how many vertices the letter
// is wrong. Both readings of the paper (IchFilter).
//
//   exact_against_ich [--vertices N] [MODEL...]
//
// Without models: the horse at 6,000 and 10,000 faces and the elephant at 50,000 of the corpus
// (GIRTH_DATA), otherwise bumpy tori of 2,000 to 10,000 faces. All vertices up to 10,000 faces,
// a hundredth of larger models; --vertices asks for N of each.

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

/// At least `count` vertices, or all, in turns of neighbours: the order in which a whole field is
/// computed. The methods change after each turn, so that what else the machine does touches all.
std::vector<std::vector<Index>> turnsOf(const girth::SurfaceMesh& mesh, std::size_t count) {
  constexpr std::size_t kTurn = 32;
  const std::vector<girth::Vertex> order = girth::coarseToFineOrder(mesh);
  const std::size_t turns = (order.size() + kTurn - 1) / kTurn;
  const std::size_t wanted = std::min(turns, (count + kTurn - 1) / kTurn);
  std::vector<std::vector<Index>> result;
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t begin = (2 * i + 1) * turns / (2 * wanted) * kTurn;
    const std::size_t end = std::min(begin + kTurn, order.size());
    result.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(begin),
                        order.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

/// One of the methods: what it has found, and what that took.
struct Run {
  const char* name;
  std::vector<GirthValue> values;
  std::size_t windows{0};
  double seconds{0};
};

void printAgainst(const Run& exact, const Run& ich) {
  std::size_t tooShort = 0, tooLong = 0;
  double least = 1, most = 1;
  for (std::size_t i = 0; i < exact.values.size(); ++i) {
    // The letter measures the farthest vertex, not the farthest point: no fault of the lemmas.
    const GirthValue &right = exact.values[i], &found = ich.values[i];
    if (right.kind == girth::LoopKind::Antipodal && found.kind == right.kind) continue;
    const double ratio = found.length / right.length;
    if (std::abs(ratio - 1) <= kSame) continue;
    ++(ratio < 1 ? tooShort : tooLong);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  const double percent = 100 / static_cast<double>(exact.values.size());
  std::printf("  %-28s %8.2f s, %5.2f times as long, %6zu windows a vertex;", ich.name, ich.seconds,
              ich.seconds / exact.seconds, ich.windows / ich.values.size());
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
  const std::vector<std::vector<Index>> turns = turnsOf(mesh, count);

  girth::GirthSolver solver(mesh);
  girth::bench::IchGirth atCreation(mesh, IchFilter::AtCreation);
  girth::bench::IchGirth atPropagation(mesh, IchFilter::AtPropagation);
  Run exact{"exact", {}}, creation{"ICH, filter at creation", {}},
      propagation{"ICH, filter at propagation", {}};
  const auto take = [](Run& run, const std::vector<Index>& turn, auto value, auto windows) {
    run.seconds += girth::bench::processorSecondsOf([&] {
      for (const Index v : turn) {
        run.values.push_back(value(v));
        run.windows += windows();
      }
    });
  };
  const auto takeIch = [&](Run& run, const std::vector<Index>& turn, girth::bench::IchGirth& ich) {
    take(
        run, turn, [&](Index v) { return ich.value(v); }, [&] { return ich.windowCount(); });
  };
  for (const std::vector<Index>& turn : turns) {
    take(
        exact, turn, [&](Index v) { return solver.value(girth::Vertex(v)).value(); },
        [&] { return solver.statistics().windowsCrossed; });
    takeIch(creation, turn, atCreation);
    takeIch(propagation, turn, atPropagation);
  }
  const std::size_t done = exact.values.size();
  std::printf("%s: %u faces, %zu %svertices\n", model.name.c_str(), mesh.faceCount(), done,
              done < all ? "of the " : "");
  std::printf("  %-28s %8.2f s %20zu windows a vertex\n", exact.name, exact.seconds,
              exact.windows / done);
  printAgainst(exact, creation);
  printAgainst(exact, propagation);
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
