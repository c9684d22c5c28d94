#include "regular_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "brute_force.h"
#include "girth/girth.h"
#include "girth/study/naive_girth.h"
#include "loop_checks.h"
#include "mesh/vector.h"
#include "regular_shapes.h"

namespace girth::test {

namespace {

/// Values are compared to this.
constexpr double kSameLength = 1e-9;
/// A loop is one if no path to its midpoint is shorter than its halves by a larger share.
constexpr double kShortest = 2e-11;
/// A third path that arrives later by a larger share decides nothing.
constexpr double kThirdIsLate = 1e-9;
/// Sequences of faces to enumerate where the two methods agree, and where they differ.
constexpr std::size_t kFew = 60'000, kMany = 3'000'000;

/// Objection of the enumeration to a value; empty: none.
std::string objection(const std::vector<BruteForce::Loop>& loops, double value, LoopKind kind) {
  bool exists = false;
  for (const BruteForce::Loop& loop : loops) {
    const bool isClear = loop.excess <= 1e-12 && loop.third < -kThirdIsLate && !loop.doubtful;
    if (loop.length < value * (1 - kSameLength) && isClear) {
      return "a loop of " + std::to_string(loop.length) + " is shorter";
    }
    exists =
        exists || (std::fabs(loop.length / value - 1) <= kSameLength && loop.excess <= kShortest);
  }
  return kind != LoopKind::Loop || exists ? "" : "there is no such loop";
}

/// The rank of the first homology of a connected surface.
std::ptrdiff_t bettiNumber(const SurfaceMesh& mesh) {
  std::ptrdiff_t edges = 0;
  for (Index h = 0; h < 3 * mesh.faceCount(); ++h) {
    const Index twin = mesh.twin(Halfedge(h));
    if (twin == kNoIndex || h < twin) ++edges;
  }
  bool isOpen = false;
  for (const Vertex v : mesh.vertices()) isOpen = isOpen || mesh.isBoundary(v);
  return (isOpen ? 1 : 2) - std::ptrdiff_t{mesh.vertexCount()} + edges -
         std::ptrdiff_t{mesh.faceCount()};
}

/// Whether positions are precise enough for straightness to be measured with them.
bool isNearOrigin(const SurfaceMesh& mesh) {
  double farthest = 0;
  for (const Vertex v : mesh.vertices()) farthest = std::max(farthest, norm(mesh.position(v)));
  return farthest * farthest < 1e3 * mesh.area();
}

void expectBarcode(GirthSolver& solver, GirthSolver& persistent, Vertex v, std::ptrdiff_t betti) {
  const auto barcode = solver.barcode(v, {});
  ASSERT_TRUE(barcode.ok());
  const std::vector<SaddleBar>& bars = barcode.value().bars;
  EXPECT_EQ(std::count_if(bars.begin(), bars.end(),
                          [](const SaddleBar& bar) { return std::isinf(bar.death); }),
            betti);
  const double girth = barcode.value().girth(0).length;
  for (const double tau : {1e-3 * girth, 0.02 * girth, 0.1 * girth, girth}) {
    persistent.setPersistence(tau);
    const GirthValue value = persistent.value(v).value();
    EXPECT_EQ(value.length, barcode.value().girth(tau).length) << "tau " << tau;
    EXPECT_EQ(value.kind, barcode.value().girth(tau).kind) << "tau " << tau;
  }
}

}  // namespace

void expectTheRestOnRegularShape(std::uint64_t seed, Index vertices) {
  const RegularShape regular = regularShape(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + regular.history);
  const SurfaceMesh mesh = regular.shape.mesh(OpenEdges::Boundary);
  const GirthField exact = girthField(mesh);
  GirthSolver solver(mesh), persistent(mesh);
  const std::ptrdiff_t betti = bettiNumber(mesh);
  const Index step = 1 + (mesh.vertexCount() - 1) / vertices;
  for (Index i = static_cast<Index>(seed % step); i < mesh.vertexCount(); i += step) {
    const Vertex v(i);
    SCOPED_TRACE("vertex " + std::to_string(i));
    const GirthLoop loop = solver.loop(v).value();
    EXPECT_EQ(loop.length, exact.values[v]);
    EXPECT_EQ(loop.kind, exact.kinds[v]);
    if (isNearOrigin(mesh)) expectGeodesicLoop(mesh, loop);
    expectBarcode(solver, persistent, v, betti);
  }
  const auto refined = refinedGirth(mesh, {});
  ASSERT_TRUE(refined.ok());
  for (const Vertex v : mesh.vertices()) {
    EXPECT_NEAR(refined.value().field.values[v] / exact.values[v], 1, kSameLength) << v;
  }
  const auto necks = findNecks(mesh, exact.values);
  ASSERT_TRUE(necks.ok());
  EXPECT_EQ(necks.value().unresolved, 0u);
  for (const Neck& neck : necks.value().necks) {
    if (!neck.measuresGirth) continue;
    for (const Vertex v : neck.vertices) EXPECT_NEAR(exact.values[v] / neck.length, 1, kSameLength);
  }
  const auto handles = findHandles(mesh);
  ASSERT_TRUE(handles.ok());
  EXPECT_EQ(handles.value().unresolved, 0u);
}

RegularChecks expectExactOnRegularShape(std::uint64_t seed, Index enumerations) {
  const RegularShape regular = regularShape(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + regular.history);
  const SurfaceMesh mesh = regular.shape.mesh(OpenEdges::Boundary);
  const GirthField exact = girthField(mesh), naive = study::naiveGirthField(mesh);
  Random random(seed);
  RegularChecks checks;
  for (const Vertex v : mesh.vertices()) {
    ++checks.vertices;
    const double value = exact.values[v], other = naive.values[v];
    const bool differ = std::fabs(value / other - 1) > kSameLength;
    if (!differ && random.below(mesh.vertexCount()) >= enumerations) continue;
    const BruteForce all(mesh, v, std::max(value, other) * (1 + 2 * kSameLength),
                         differ ? kMany : kFew);
    if (!all.complete()) {
      EXPECT_FALSE(differ) << "vertex " << v << ": exact " << value << ", naive " << other;
      continue;
    }
    const auto loops = all.loops();
    ++checks.enumerated;
    const std::string wrong = objection(loops, value, exact.kinds[v]);
    const std::string naiveWrong = objection(loops, other, naive.kinds[v]);
    EXPECT_EQ(wrong, "") << "vertex " << v << ": exact " << value << ", naive " << other;
    EXPECT_EQ(naiveWrong, "") << "vertex " << v << ": exact " << value << ", naive " << other;
    if (differ && wrong.empty() && naiveWrong.empty()) ++checks.ties;
  }
  return checks;
}

}  // namespace girth::test
