// Random surfaces by the thousand. One of them alone:
// long_tests --gtest_filter='RandomMeshes/*/1017'

#include <gtest/gtest.h>

#include <string>

#include "core/mesh_properties.h"

namespace girth::test {
namespace {

class Properties : public testing::TestWithParam<int> {};

TEST_P(Properties, Hold) { expectProperties(static_cast<std::uint64_t>(GetParam())); }

INSTANTIATE_TEST_SUITE_P(RandomMeshes, Properties, testing::Range(100, 1300),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace girth::test
