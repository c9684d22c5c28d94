// Repair of topology on fifty isosurfaces.

#include <gtest/gtest.h>

#include <cstdint>

#include "core/small_handles.h"

namespace girth::test {
namespace {

TEST(LongRemoveHandles, ofFiftyIsosurfacesTakesTheSmallOnesAlone) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) expectSmallHandlesRemoved(seed);
}

}  // namespace
}  // namespace girth::test
