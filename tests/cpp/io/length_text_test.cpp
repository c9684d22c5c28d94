// Lengths as people type them: the cases that the page's parser is held to as well.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "test_paths.h"
#include "text/length_text.h"
#include "text/number_text.h"

namespace girth::io {
namespace {

TEST(LengthText, readsAsThePageDoes) {
  std::ifstream file(test::testData() + "/lengths.json");
  const auto cases = nlohmann::json::parse(file);
  ASSERT_GT(cases.size(), 20u);
  for (const auto& one : cases) {
    const auto text = one["text"].get<std::string>(), unit = one["unit"].get<std::string>();
    const Result<double> length = lengthInUnit(text, unit);
    if (one.contains("fault")) {
      ASSERT_FALSE(length.ok()) << text;
      EXPECT_NE(length.error().message.find(one["fault"].get<std::string>()), std::string::npos)
          << length.error().message;
    } else {
      ASSERT_TRUE(length.ok()) << text;
      EXPECT_EQ(length.value(), one["length"].get<double>()) << text << " in " << unit;
    }
  }
}

TEST(LengthText, keepsTheUnitThatWasTyped) {
  EXPECT_EQ(parseLength("900mm").value().unit, findLengthUnit("mm"));
  EXPECT_EQ(parseLength("900").value().unit, nullptr);
}

TEST(LengthText, readsSharesAsThePageDoes) {
  std::ifstream file(test::testData() + "/shares.json");
  const auto cases = nlohmann::json::parse(file);
  ASSERT_GT(cases.size(), 10u);
  for (const auto& one : cases) {
    const auto text = one["text"].get<std::string>();
    const Result<double> length = lengthOrShare(text, "mm", one["whole"].get<double>());
    ASSERT_EQ(length.ok(), one.contains("length")) << text;
    if (length) {
      EXPECT_EQ(length.value(), one["length"].get<double>()) << text;
    } else {
      EXPECT_NE(length.error().message.find(one["fault"].get<std::string>()), std::string::npos)
          << length.error().message;
    }
  }
}

TEST(NumberText, isReadAsOnThePage) {
  std::ifstream file(test::testData() + "/numbers.json");
  const auto cases = nlohmann::json::parse(file);
  ASSERT_GT(cases.size(), 10u);
  for (const auto& one : cases) {
    EXPECT_EQ(readableNumber(one["value"].get<double>()), one["text"].get<std::string>());
  }
}

}  // namespace
}  // namespace girth::io
