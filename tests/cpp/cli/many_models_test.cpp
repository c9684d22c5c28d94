// Many models in one call: one answer each, several at a time.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, everyFileHasAnAnswerAlsoTheOnesThatFail) {
  const std::string prism = kData + "/prism.obj", absent = path("absent.obj"),
                    bad = kData + "/bad/nan.obj";
  for (const char* jobs : {"1", "3"}) {
    const Outcome outcome =
        run({"info", prism, absent, prism, bad, prism, "--json", "--jobs", jobs});
    EXPECT_EQ(outcome.exitCode, 2);
    const auto lines = linesOf(outcome.output);
    ASSERT_EQ(lines.size(), 5u) << outcome.output;
    EXPECT_EQ(linesOf(outcome.errors).size(), 2u) << outcome.errors;
    EXPECT_EQ(Json::parse(lines[0])["faces"], 84);
    EXPECT_EQ(Json::parse(lines[1])["file"], absent);
    EXPECT_EQ(Json::parse(lines[1])["error"]["code"], "FILE_NOT_FOUND");
    EXPECT_EQ(Json::parse(lines[2]), Json::parse(lines[0]));
    const Json error = Json::parse(lines[3])["error"];
    EXPECT_EQ(error["code"], "NON_FINITE_POSITION");
    EXPECT_FALSE(error["message"].get<std::string>().empty());
    EXPECT_FALSE(error["hint"].get<std::string>().empty());
  }
  const Outcome one = run({"parts", absent, "--json"});
  EXPECT_EQ(Json::parse(one.output)["error"]["code"], "FILE_NOT_FOUND");
}

TEST_F(Command, severalOutputsGoIntoAFolder) {
  fs::create_directory(path("models"));
  fs::create_directory(path("values"));
  for (const char* name : {"models/a.obj", "models/b.obj"}) {
    fs::copy_file(kData + "/prism.obj", path(name));
  }
  const std::vector<std::string> models{path("models/a.obj"), path("models/b.obj")};
  ASSERT_EQ(run({"igf", models[0], "-o", path("one.csv")}).exitCode, 0);
  const Outcome outcome =
      run({"igf", models[0], models[1], "--jobs", "2", "-o", path("values/"), "--format", "csv"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  for (const char* name : {"values/a.csv", "values/b.csv"}) {
    EXPECT_EQ(contentOf(path(name)), contentOf(path("one.csv"))) << name;
  }
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"igf", models[0], models[1], "-o", path("one.csv")},
        {"igf", models[0], models[1], "-o", path("values")},
        {"igf", models[0], models[0], "-o", path("values"), "--format", "csv"},
        {"igf", models[0], models[1], "--jobs", "0"}}) {
    EXPECT_EQ(run(arguments).exitCode, 1);
  }
  EXPECT_EQ(run({"igf", models[0], "-o", path("none/"), "--format", "csv"}).exitCode, 2);
}

}  // namespace
}  // namespace girth::test
