// Real models from outside the repository, where GIRTH_DATA names a folder of them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "girth/io/read_mesh.h"
#include "loop_checks.h"

namespace girth::test {
namespace {

TEST(Corpus, ExactAgreesWithNaiveAndLoopsAreGeodesic) {
  const char* data = std::getenv("GIRTH_DATA");
  if (data == nullptr) GTEST_SKIP() << "skipped: no corpus";
  const std::filesystem::path models = std::filesystem::path(data) / "models";
  int tested = 0;
  for (const char* name : {"homer_12000f.obj", "hand_20686f.obj", "fertility_24908f_g4.obj"}) {
    SCOPED_TRACE(name);
    std::ifstream file(models / name, std::ios::binary);
    if (!file) continue;
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto loaded = io::readMesh(std::as_bytes(std::span(text)), name);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    const SurfaceMesh& mesh = loaded.value().mesh;
    GirthSolver solver(mesh);
    const std::vector<Index> order = coarseToFineOrder(mesh);
    for (std::size_t i = 0; i < 8; ++i) {
      const GirthLoop loop = solver.loop(order[i]).value();
      const GirthValue naive = naiveGirth(mesh, order[i]).value();
      EXPECT_NEAR(loop.length / naive.length, 1, 1e-9) << "vertex " << order[i];
      EXPECT_EQ(loop.kind, naive.kind) << "vertex " << order[i];
    }
    for (std::size_t i = 0; i < 300; ++i) {
      expectGeodesicLoop(mesh, solver.loop(order[i]).value());
    }
    ++tested;
  }
  EXPECT_GT(tested, 0) << "no model in " << models;
}

}  // namespace
}  // namespace girth::test
