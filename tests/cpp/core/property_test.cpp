// Random surfaces, a sample of what the long run tests. One of them alone:
// core_tests --gtest_filter='RandomMeshes/*/17'

#include <gtest/gtest.h>

#include "mesh_properties.h"

namespace girth::test {
namespace {

class Properties : public testing::TestWithParam<int> {};

TEST_P(Properties, Hold) { expectProperties(static_cast<std::uint64_t>(GetParam())); }

INSTANTIATE_TEST_SUITE_P(RandomMeshes, Properties, testing::Range(0, 24));

}  // namespace
}  // namespace girth::test
