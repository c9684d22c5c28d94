#include "mesh_properties.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "girth/girth.h"
#include "girth_proof.h"
#include "random_meshes.h"

namespace girth::test {

namespace {

std::string at(Index vertex) { return "vertex " + std::to_string(vertex); }

/// Values of a surface at the vertices that it shares with another one, in which `newNumber` says
/// which they are.
void expectSame(const GirthField& values, const Shape& other, double scale,
                const std::vector<Index>& newNumber, const char* how) {
  if (!isSurface(other)) return;  // a plane may pass too near a vertex
  SCOPED_TRACE(how);
  const SurfaceMesh mesh = other.mesh();
  GirthSolver solver(mesh);
  for (std::size_t v = 0; v < values.values.size(); v += 3) {
    const GirthValue value =
        solver.value(newNumber.empty() ? static_cast<Index>(v) : newNumber[v]).value();
    EXPECT_NEAR(value.length / (scale * values.values[v]), 1, 1e-9) << at(static_cast<Index>(v));
  }
}

}  // namespace

void expectProperties(std::uint64_t seed) {
  const RandomMesh random = randomMesh(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.history);
  const SurfaceMesh mesh = random.shape.mesh();
  ExecutionContext one, three;
  one.threads = 1;
  three.threads = 3;
  const GirthField exact = girthField(mesh, GirthMethod::Exact, one);
  const GirthField again = girthField(mesh, GirthMethod::Exact, three);

  GirthSolver solver(mesh);
  TextbookMmp textbook(mesh);
  for (Index v = mesh.vertexCount(); v-- > 0;) {
    const GirthValue naive = naiveGirth(mesh, v).value();
    EXPECT_NEAR(exact.values[v] / naive.length, 1, 1e-9) << at(v) << ", naive " << naive.length;
    EXPECT_EQ(exact.kinds[v], naive.kind) << at(v);
    EXPECT_EQ(again.values[v], exact.values[v]) << at(v);
    EXPECT_EQ(again.kinds[v], exact.kinds[v]) << at(v);
    const GirthLoop loop = solver.loop(v).value();
    EXPECT_EQ(loop.length, exact.values[v]) << at(v);
    EXPECT_EQ(loop.kind, exact.kinds[v]) << at(v);
    if (v % 16 == 0) {
      SCOPED_TRACE(at(v));
      expectProven(mesh, textbook, loop, 0.05);
    }
  }
  std::vector<Index> newNumber;
  const Shape renumbered = relabelled(random.shape, seed, newNumber);
  expectSame(exact, renumbered, 1, newNumber, "renumbered");
  expectSame(exact, moved(random.shape, 3.7, 0.3, 2), 3.7, {}, "moved");
  expectSame(exact, subdivided(random.shape), 1, {}, "subdivided");
  expectSame(exact, divided(random.shape, 0.2, 20, seed), 1, {}, "divided");
  expectSame(exact, reflected(random.shape, seed), 1, {}, "reflected");
}

}  // namespace girth::test
