// Exact against naive at all vertices of meshes of 1,000 to 4,000 faces: genus 0 to 4, good and bad
// triangulations, noise of half a mean edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/corpus.h"
#include "core/random_meshes.h"
#include "core/shapes.h"
#include "girth/girth.h"
#include "girth/io/load_mesh.h"
#include "girth/study/naive_girth.h"
#include "test_paths.h"

namespace girth::test {
namespace {

void expectNaive(const SurfaceMesh& mesh, Index genus) {
  ASSERT_EQ(mesh.genus(0), genus);
  EXPECT_GE(mesh.faceCount(), 1000u);
  EXPECT_LE(mesh.faceCount(), 4000u);
  const GirthField exact = girthField(mesh), naive = study::naiveGirthField(mesh);
  for (const Vertex v : mesh.vertices()) {
    EXPECT_NEAR(exact.values[v] / naive.values[v], 1, 1e-9) << "vertex " << v;
    EXPECT_EQ(exact.kinds[v], naive.kinds[v]) << "vertex " << v;
  }
}

struct Case {
  const char* name;
  Index genus;
  std::function<Shape()> shape;
};

/// Drawn by name, so that a failure says which.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"NoisySphere", 0, [] { return perturbed(icosphere(3), 0.5, 1); }},
      {"CubeOfSquares", 0, [] { return box(1, 1, 1, 14, 14, 14); }},
      {"PrismRetriangulated", 0,
       [] { return retriangulated(prism(regularPolygon(6, 1, 4), 8, 30), 2); }},
      {"NoisyTorus", 1, [] { return perturbed(torus(2, 0.7, 60, 30), 0.5, 3); }},
      {"TorusStretchedThirtyfold", 1,
       [] {
         Shape shape = torus(2, 0.7, 40, 20);
         for (Index v = 0; v < shape.vertexCount(); ++v) shape.positions[3 * v] *= 30;
         return shape;
       }},
      {"FrameOfSlivers", 1,
       [] { return divided(perturbed(subdivided(subdivided(plate(1))), 0.1, 4), 1e-3, 200, 4); }},
      {"NoisyPretzel", 2, [] { return perturbed(subdivided(subdivided(plate(1, 2))), 0.5, 5); }},
      {"PretzelRetriangulated", 2,
       [] { return retriangulated(subdivided(subdivided(plate(1, 2))), 6); }},
      {"NoisyBarOfThreeHandles", 3,
       [] { return perturbed(subdivided(subdivided(plate(1, 3))), 0.5, 7); }},
      {"NoisyPlateOfFourHandles", 4,
       [] { return perturbed(subdivided(subdivided(plate(2))), 0.5, 8); }},
      {"PlateOfFourHandles", 4, [] { return subdivided(subdivided(plate(2))); }},
  };
  return all;
}

class ExactIsNaive : public testing::TestWithParam<std::size_t> {};

TEST_P(ExactIsNaive, AtAllVertices) {
  const Case& c = cases()[GetParam()];
  expectNaive(c.shape().mesh(), c.genus);
}

INSTANTIATE_TEST_SUITE_P(Meshes, ExactIsNaive, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& test) { return std::string(cases()[test.param].name); });

TEST(ExactIsNaiveOnAHorse, AtAllVertices) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  expectNaive(corpusModel("horse_1500f.off"), 0);
}

/// All vertices of small models, some of larger ones. The naive method keeps every window: models
/// of more than 20,000 faces are left out, and the rest of one where it gives up.
void expectNaiveAtSome(const SurfaceMesh& mesh) {
  constexpr Index kWhole = 1200, kSome = 200, kLarge = 20'000;
  if (mesh.faceCount() > kLarge) return;
  const Index vertices = mesh.vertexCount();
  const Index count = vertices <= kWhole ? vertices : kSome;
  GirthSolver solver(mesh);
  for (Index i = 0; i < count; ++i) {
    const Vertex v(static_cast<Index>(std::uint64_t{i} * vertices / count));
    const GirthValue exact = solver.value(v).value();
    const auto found = study::naiveGirth(mesh, v);
    if (!found) {
      ASSERT_EQ(found.error().code, ErrorCode::LimitExceeded);
      std::printf("  left at vertex %u: %s\n", Index{v}, found.error().message.c_str());
      return;
    }
    const GirthValue& naive = found.value();
    if (exact.kind == LoopKind::Unresolved) continue;
    EXPECT_NEAR(exact.length / naive.length, 1, 1e-9) << "vertex " << v;
  }
}

/// Shares of the corpus that can be tried side by side.
constexpr std::size_t kShares = 32;

class ExactIsNaiveOnTheCorpus : public testing::TestWithParam<std::size_t> {};

TEST_P(ExactIsNaiveOnTheCorpus, InEveryFile) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpusFolder())) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  int surfaces = 0;
  for (std::size_t i = GetParam(); i < files.size(); i += kShares) {
    const auto loaded = io::loadMesh(files[i]);
    if (!loaded) continue;
    SCOPED_TRACE(files[i]);
    std::printf("%s: %u faces\n", files[i].c_str(), loaded.value().mesh.faceCount());
    std::fflush(stdout);
    expectNaiveAtSome(loaded.value().mesh);
    ++surfaces;
  }
  EXPECT_GE(surfaces, 10);
}

INSTANTIATE_TEST_SUITE_P(Shares, ExactIsNaiveOnTheCorpus, testing::Range(std::size_t{0}, kShares));

}  // namespace
}  // namespace girth::test
