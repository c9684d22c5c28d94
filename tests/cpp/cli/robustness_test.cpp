// girth study robustness as a user runs it.
#include <nlohmann/json.hpp>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, studyOfRobustness) {
  const std::string model = kData + "/prism.obj";
  const std::vector<std::string> study{"study", "robustness", model, "--size", "200"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), study.begin(), study.end());
    return more;
  };
  const Outcome table = run(
      with({"--sizes", "100,300", "--poses", model, "-o", path("table.csv"), "--threads", "1"}));
  EXPECT_EQ(table.exitCode, 0) << table.errors;
  EXPECT_NE(table.output.find("pose prism.obj"), std::string::npos);
  const auto lines = linesOf(contentOf(path("table.csv")));
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(lines[0], "figure,change,faces,difference,unchanged,paper,note");
  EXPECT_TRUE(lines[1].starts_with("7,remeshed to 100,"));
  EXPECT_TRUE(lines[9].starts_with("9,pose prism.obj,"));

  const Outcome printed = run(with({"--sizes", "100", "--json", "--threads", "1"}));
  EXPECT_EQ(printed.exitCode, 0) << printed.errors;
  const Json json = Json::parse(printed.output);
  ASSERT_EQ(json["rows"].size(), 7u);
  EXPECT_EQ(json["rows"][1]["figure"], "8b");
  EXPECT_EQ(json["rows"][1]["paper"], 0.0077);
  // A convex prism has no parts that could grow together.
  EXPECT_TRUE(json["rows"][6]["difference"].is_null());
  EXPECT_NE(json["rows"][6]["note"], "");

  EXPECT_EQ(run(with({"-o", path("table.txt")})).exitCode, 1);
  EXPECT_EQ(run(with({"--stretch", "nan"})).exitCode, 1);
  EXPECT_EQ(run(with({"--handles", "0"})).exitCode, 1);
  EXPECT_EQ(run(with({"--sizes", "1"})).exitCode, 1);
  EXPECT_EQ(run(with({"--poses", path("absent.obj")})).exitCode, 2);
  EXPECT_EQ(run({"study", "robustness", path("absent.obj")}).exitCode, 2);
}

}  // namespace
}  // namespace girth::test
