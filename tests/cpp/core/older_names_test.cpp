// Older names mean the same as the present ones, until 2.0.
#include <gtest/gtest.h>

#include <vector>

#include "girth/necks.h"
#include "girth/refine_surface.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace girth::test {
namespace {

TEST(OlderNames, meanTheSame) {
  EXPECT_EQ(OpenEdges::Wall, OpenEdges::Boundary);
  const TriangleSoup sheet{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};
  const auto fine = refineSurface(prepareSurface(sheet).value(), 13);
  ASSERT_TRUE(fine.ok());
  EXPECT_EQ(fine.value().mesh.faceCount(),
            subdivideSurface(prepareSurface(sheet).value(), 13).value().mesh.faceCount());
  std::vector<Neck> necks(2);
  necks[0].length = 3;
  necks[1].length = 2;
  EXPECT_DOUBLE_EQ(suggestedProminence(necks), 0.1);
  EXPECT_EQ(suggestedProminence({}), 0);
}

}  // namespace
}  // namespace girth::test
#pragma GCC diagnostic pop
