// A sample of real models; the long run has more of them.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "corpus.h"
#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "girth_proof.h"
#include "loop_checks.h"
#include "shapes.h"

namespace girth::test {
namespace {

TEST(Corpus, ExactAgreesWithNaiveAndLoopsAreGeodesic) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  for (const char* name : {"homer_12000f.obj", "hand_20686f.obj", "fertility_24908f_g4.obj"}) {
    SCOPED_TRACE(name);
    const SurfaceMesh mesh = corpusModel(name);
    GirthSolver solver(mesh);
    const std::vector<Vertex> order = coarseToFineOrder(mesh);
    for (std::size_t i = 0; i < 8; ++i) {
      const GirthLoop loop = solver.loop(Vertex(order[i])).value();
      const GirthValue naive = study::naiveGirth(mesh, Vertex(order[i])).value();
      EXPECT_NEAR(loop.length / naive.length, 1, 1e-9) << "vertex " << order[i];
      EXPECT_EQ(loop.kind, naive.kind) << "vertex " << order[i];
    }
    for (std::size_t i = 0; i < 300; ++i) {
      expectGeodesicLoop(mesh, solver.loop(Vertex(order[i])).value());
    }
  }
}

TEST(Corpus, ValuesAreProven) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  Random random(2);
  for (const std::string& name : corpusModels(12000)) {
    const SurfaceMesh mesh = corpusModel(name);
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    for (int i = 0; i < 5; ++i) {
      const Index vertex = random.below(mesh.vertexCount());
      SCOPED_TRACE(name + ", vertex " + std::to_string(vertex));
      expectProven(mesh, textbook, solver.loop(Vertex(vertex)).value(), 0.03);
    }
  }
}

}  // namespace
}  // namespace girth::test
