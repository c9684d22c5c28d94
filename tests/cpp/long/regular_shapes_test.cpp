// Regular shapes with rounded coordinates by the thousand: exact, naive and enumerated girth. A
// hundred of them alone: long_tests --gtest_filter='RegularShapes/*/17'

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "core/regular_checks.h"

namespace girth::test {
namespace {

constexpr int kShapes = 100;

class Hundred : public testing::TestWithParam<int> {};

TEST_P(Hundred, AreExact) {
  RegularChecks sum;
  for (int i = 0; i < kShapes; ++i) {
    const auto seed = static_cast<std::uint64_t>(GetParam() * kShapes + i);
    const RegularChecks checks = expectExactOnRegularShape(seed, 1);
    sum.vertices += checks.vertices;
    sum.enumerated += checks.enumerated;
    sum.ties += checks.ties;
    if (i % 10 == 0) expectTheRestOnRegularShape(seed, 8);
  }
  std::printf("%u vertices, %u of them by enumeration, %u ties\n", sum.vertices, sum.enumerated,
              sum.ties);
  EXPECT_LE(sum.ties, 20u);
}

INSTANTIATE_TEST_SUITE_P(RegularShapes, Hundred, testing::Range(0, 210),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace girth::test
