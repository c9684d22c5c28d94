// Saddles and maxima of the distance from p are found by different ways. On a closed surface of
// genus g their numbers fit: 1 - saddles + maxima = 2 - 2 g (web/docs/definitions.md,
// Statement 2.3).
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "corpus.h"
#include "geodesic/locate.h"
#include "shapes.h"
#include "solver/persistence/persistent_search.h"
#include "solver/search/loop_search.h"

namespace girth::test {
namespace {

using geodesic::Propagation;
using geodesic::Unfolding;

/// The numbers fit at these vertices. Returns how many saddles there were.
std::size_t expectCountsFit(const SurfaceMesh& mesh, int genus,
                            const std::vector<Index>& vertices) {
  const Unfolding unfolding(mesh);
  Propagation propagation(unfolding);
  LoopSearch loops(propagation);
  PersistentSearch search(propagation, loops);
  std::size_t all = 0;
  for (const Index v : vertices) {
    const auto source = geodesic::locate(unfolding, SurfacePoint::atVertex(Vertex(v)));
    if (!source) {
      ADD_FAILURE() << source.error().message;
      return all;
    }
    constexpr double kForEver = std::numeric_limits<double>::infinity();
    search.start(kForEver, std::numeric_limits<std::size_t>::max(), true, kForEver, nullptr);
    propagation.run(std::span(&source.value(), 1), geodesic::Keep::Front, search);
    const auto saddles = static_cast<int>(search.saddles().size());
    if (saddles == 0) continue;  // then no maximum is looked for
    EXPECT_EQ(1 - saddles + static_cast<int>(search.maxima().size()), 2 - 2 * genus)
        << "vertex " << v << ", " << saddles << " saddles";
    all += search.saddles().size();
  }
  return all;
}

std::vector<Index> everyVertex(const SurfaceMesh& mesh, Index step) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertexCount(); v += step) vertices.push_back(v);
  return vertices;
}

TEST(SaddleCount, FitsTheMaximaOnRodsWithBumps) {
  // At one vertex of each a path passes so close beside a vertex that the way over it ties.
  const std::pair<std::uint64_t, Index> cases[] = {{2, 782}, {3, 994}, {5, 1688}};
  std::size_t saddles = 0;
  for (const auto& [seed, close] : cases) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = perturbed(bumpyRod(30, 90, 9), 0.1, seed).mesh();
    std::vector<Index> vertices = everyVertex(mesh, 23);
    vertices.push_back(close);
    saddles += expectCountsFit(mesh, 0, vertices);
  }
  EXPECT_GT(saddles, 1500U);
}

TEST(SaddleCount, FitsTheMaximaOnRoughTori) {
  std::size_t saddles = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = perturbed(torus(2, 0.7, 32, 16), 0.3, seed).mesh();
    saddles += expectCountsFit(mesh, 1, everyVertex(mesh, 2));
  }
  EXPECT_GT(saddles, 3000U);
}

// Vertices at which it did not fit once: a way that bends at a vertex beside which the shortest
// path passes was taken for one more path, or three roots gave a point to half the digits only.
TEST(SaddleCount, FitsTheMaximaOnRealModels) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  const std::pair<const char*, std::vector<Index>> cases[] = {
      {"cat0", {40, 240, 295, 539, 730, 1100, 1610, 4450}},
      {"cat3", {2305, 2520, 2585, 4170, 4185}},
      {"centaur0", {4860}},
      {"wolf0", {1065}},
  };
  for (const auto& [name, vertices] : cases) {
    SCOPED_TRACE(name);
    const std::string file = std::string("../retrieval/tosca_iso_5k/") + name + ".off";
    expectCountsFit(corpusModel(file), 0, vertices);
  }
}

}  // namespace
}  // namespace girth::test
