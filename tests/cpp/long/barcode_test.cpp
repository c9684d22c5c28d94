// Barcodes at every vertex of random surfaces. One of them alone:
// long_tests --gtest_filter='RandomMeshes/SampledBarcodes.Agree/17'

#include <gtest/gtest.h>

#include <string>

#include "core/barcode_checks.h"

namespace girth::test {
namespace {

class SampledBarcodes : public testing::TestWithParam<int> {};

TEST_P(SampledBarcodes, Agree) {
  expectSampledBarcodes(static_cast<std::uint64_t>(GetParam()), 0, 0.03);
}

TEST_P(SampledBarcodes, AreForeseen) {
  for (std::uint64_t k = 0; k < 2; ++k) {
    expectPersistentGirths(100 * k + static_cast<std::uint64_t>(GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(RandomMeshes, SampledBarcodes, testing::Range(1, 51),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace girth::test
