#include "regular_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "brute_force.h"
#include "girth/girth.h"
#include "girth/study/naive_girth.h"
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

/// What enumeration has against a value; empty: nothing.
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

}  // namespace

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
