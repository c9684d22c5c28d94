// Real models: values proven at thousands of random vertices, and the engine against the naive
// algorithm at all vertices of coarse ones.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "core/corpus.h"
#include "core/girth_proof.h"
#include "core/shapes.h"
#include "girth/girth.h"

namespace girth::test {
namespace {

TEST(LongCorpus, ValuesAreProvenAtThousandsOfVertices) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  int tested = 0, seen = 0;
  std::uint64_t seed = 1;
  for (const std::string& name : corpusModels(kNoIndex)) {
    const SurfaceMesh mesh = corpusModel(name);
    GirthSolver solver(mesh);
    TextbookMmp textbook(mesh);
    Random random(seed++);
    const int count = mesh.faceCount() < 10000 ? 220 : mesh.faceCount() < 30000 ? 80 : 40;
    int seenHere = 0;
    for (int i = 0; i < count; ++i) {
      const Index vertex = random.below(mesh.vertexCount());
      SCOPED_TRACE(name + ", vertex " + std::to_string(vertex));
      if (expectProven(mesh, textbook, solver.loop(Vertex(vertex)).value(), 0.03)) ++seenHere;
    }
    std::printf("%s: %d proven, %d of the saddles seen at their place\n", name.c_str(), count,
                seenHere);
    std::fflush(stdout);
    tested += count;
    seen += seenHere;
  }
  std::printf("%d vertices in all, %d of the saddles seen at their place\n", tested, seen);
  EXPECT_GE(tested, 2000);
  EXPECT_GT(seen, tested / 2);
}

}  // namespace
}  // namespace girth::test
