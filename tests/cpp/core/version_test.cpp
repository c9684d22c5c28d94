// The version: the same in the headers and in the library.
#include "girth/version.h"

#include <gtest/gtest.h>

#include <string>

namespace girth {
namespace {

TEST(Version, NumbersAndTextAgree) {
  EXPECT_EQ(version(), GIRTH_VERSION);
  EXPECT_EQ(std::to_string(GIRTH_VERSION_MAJOR) + "." + std::to_string(GIRTH_VERSION_MINOR) + "." +
                std::to_string(GIRTH_VERSION_PATCH),
            GIRTH_VERSION);
}

}  // namespace
}  // namespace girth
