// girth cut: along handles, contours and loops of a file, and a file for each part.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, aFrameIsCutAlongItsHandle) {
  const std::string model = write("frame.obj", frame());
  // Cut round a bar it is a tube with two ends, and round its hole a band.
  const Json handles = Json::parse(run({"handles", model, "--json"}).output)["handles"];
  ASSERT_EQ(handles.size(), 2u);
  for (const std::string which : {"1", "2"}) {
    const Outcome outcome = run({"cut", model, "--handle", which, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const Json parts = Json::parse(outcome.output)["parts"];
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0]["genus"], 0);
    EXPECT_EQ(parts[0]["boundaries"], 2);
  }
  const Json parts =
      Json::parse(run({"cut", model, "--handles", "--cap", "--json"}).output)["parts"];
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0]["genus"], 0);
  EXPECT_EQ(parts[0]["boundaries"], 0);
  EXPECT_TRUE(contains(run({"cut", model, "--handle", "3"}).errors,
                       "there is no handle 3; handles and tunnels are numbered from 1 to 2"));
  const Outcome none = run({"cut", kData + "/prism.obj", "--handle", "1"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_TRUE(contains(none.errors, "there is no handle 1; the model has none")) << none.errors;
  // Nothing to cut along leaves the model whole.
  EXPECT_EQ(
      Json::parse(run({"cut", kData + "/prism.obj", "--handles", "--json"}).output)["parts"].size(),
      1u);
}

TEST_F(Command, anHourglassIsCutAtAContour) {
  const std::string model = write("hourglass.obj", hourglass());
  // Above and below the waist the girth passes 7 once each.
  const Outcome outcome = run({"cut", model, "--unit", "cm", "--at", "70mm", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(Json::parse(outcome.output)["parts"].size(), 3u);
  EXPECT_TRUE(contains(run({"cut", model, "--at", "7"}).output, "cut along 2 loops: 3 parts\n"));
  EXPECT_EQ(Json::parse(run({"cut", model, "--at", "0", "--json"}).output)["parts"].size(), 1u);
  for (const std::string level : {"-1", "nan", "inf", "wide", ""}) {
    const Outcome refused = run({"cut", model, "--at", level});
    EXPECT_EQ(refused.exitCode, 1) << level;
    EXPECT_FALSE(refused.errors.empty());
  }
}

TEST_F(Command, loopsOfAFileAreCutAlong) {
  const std::string model = write("hourglass.obj", hourglass());
  const Json expected = Json::parse(run({"cut", model, "--neck", "1", "--json"}).output)["parts"];
  for (const std::vector<std::string>& finding : {std::vector<std::string>{"necks", model},
                                                  {"loop", model, "6"},
                                                  {"loop", model, "8"},
                                                  {"bottleneck", model, "0", "12"}}) {
    std::vector<std::string> writing = finding;
    writing.insert(writing.end(), {"-o", path("curves.json")});
    ASSERT_EQ(run(writing).exitCode, 0);
    const Outcome outcome = run({"cut", model, "--along", path("curves.json"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(Json::parse(outcome.output)["parts"], expected);
  }
  // A loop across faces, based inside one.
  ASSERT_EQ(run({"loop", model, "--face", "3", "-o", path("curves.json")}).exitCode, 0);
  EXPECT_EQ(run({"cut", model, "--along", path("curves.json")}).exitCode, 0);
}

TEST_F(Command, damagedFilesOfLoopsAreNamed) {
  const std::string model = write("hourglass.obj", hourglass());
  const std::string point = R"({"vertices":[0],"weights":[1]})";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "it is no JSON"},
      {"{\"points\":", "it is no JSON"},
      {"[1]", "it is no JSON object"},
      {"{}", "no array \"points\""},
      {R"({"necks":3})", "\"necks\" is no array"},
      {R"({"necks":[3]})", "no array \"points\""},
      {R"({"points":[3]})", "has no \"vertices\""},
      {R"({"points":[{"vertices":[],"weights":[]}]})", "not one, two or three"},
      {R"({"points":[{"vertices":[0,1],"weights":[1]}]})", "not one, two or three"},
      {R"({"points":[{"vertices":[0],"weights":["a"]}]})", "is no number"},
      {R"({"points":[{"vertices":[99],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[-1],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[null],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[0,14],"weights":[0.5,0.5]}]})", "an edge that the model"},
      {R"({"points":[{"vertices":[0,1,14],"weights":[0.5,0.25,0.25]}]})", "a face that the model"},
      {R"({"points":[{"vertices":[0,1],"weights":[7,-6]},)" + point + "]}", "none of the surface"},
      {R"({"points":[)" + point + R"(,{"vertices":[14],"weights":[1]}]})", "no face of the point"}};
  for (const auto& [content, words] : cases) {
    const std::string file = write("curves.json", content);
    const Outcome outcome = run({"cut", model, "--along", file});
    EXPECT_NE(outcome.exitCode, 0) << content;
    EXPECT_TRUE(contains(outcome.errors, words)) << content << outcome.errors;
  }
  EXPECT_TRUE(contains(run({"cut", model, "--along", path("absent.json")}).errors,
                       "absent.json: FILE_NOT_FOUND"));
}

TEST_F(Command, eachPartHasAFile) {
  const std::string model = write("hourglass.obj", hourglass());
  for (const std::string ending : {"stl", "obj", "ply", "off", "glb"}) {
    const Outcome outcome =
        run({"cut", model, "--neck", "1", "--cap", "-o", path("half-*." + ending)});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    for (const char* number : {"1", "2"}) {
      const Outcome info =
          run({"info", path("half-" + std::string(number) + "." + ending), "--json"});
      ASSERT_EQ(info.exitCode, 0) << info.errors;
      EXPECT_EQ(Json::parse(info.output)["faces"], 16) << ending;  // twelve and a cap of four
    }
    EXPECT_FALSE(fs::exists(path("half-3." + ending)));
  }
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments{"cut", model, "--neck", "1", "-o"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << outcome.errors;
  };
  refused({path("parts.stl")}, "put a star into the name");
  refused({path("part-*.csv")}, "leave the star out");
  refused({path("part-*")}, "no known ending");
  // The second part would replace the model.
  fs::copy_file(model, path("glass-2.obj"));
  const Outcome outcome =
      run({"cut", path("glass-2.obj"), "--neck", "1", "-o", path("glass-*.obj")});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(contains(outcome.errors, "it would replace the model that is read"));
  EXPECT_FALSE(fs::exists(path("glass-1.obj")));
  // No folder to write to.
  EXPECT_TRUE(contains(run({"cut", model, "--neck", "1", "-o", path("none/part-*.stl")}).errors,
                       "FILE_UNWRITABLE"));
}

TEST_F(Command, oneThingIsCutAlong) {
  const std::string model = write("hourglass.obj", hourglass());
  for (const std::vector<std::string>& two : {std::vector<std::string>{"6", "--necks"},
                                              {"--neck", "1", "--handles"},
                                              {"--at", "7", "--along", "x.json"},
                                              {"--neck", "1", "--necks"}}) {
    std::vector<std::string> arguments{"cut", model};
    arguments.insert(arguments.end(), two.begin(), two.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(contains(outcome.errors, "several things to cut along are named"));
  }
}

}  // namespace
}  // namespace girth::test
