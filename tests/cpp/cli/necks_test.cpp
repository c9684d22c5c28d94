// girth necks and girth cut, on an hourglass of known girth.
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, necksOfAnHourglass) {
  const std::string model = write("hourglass.obj", hourglass());
  const Outcome outcome = run({"necks", model, "--unit", "cm", "-o", path("necks.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("necks.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  EXPECT_EQ(all["unit"], "centimetre");
  ASSERT_EQ(all["necks"].size(), 1u);
  const Json& neck = all["necks"][0];
  EXPECT_NEAR(neck["length"].get<double>(), 6, 1e-5);  // the file has six decimals
  EXPECT_TRUE(neck["prominence"].is_null());
  EXPECT_EQ(neck["vertices"], Json({6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(neck["points"].size(), 7u);
  EXPECT_EQ(neck["points"][0], neck["points"][6]);
  EXPECT_TRUE(contains(run({"necks", model}).output, "1 neck\n"));

  ASSERT_EQ(run({"necks", model, "-o", path("necks.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("necks.csv")));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].rfind("0,", 0), 0u);
  ASSERT_EQ(run({"necks", model, "-o", path("necks.obj")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("necks.obj")), "l 1 2 3 4 5 6 1\n"));
  ASSERT_EQ(run({"necks", model, "-o", path("necks.glb")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("necks.glb")), "\"neck_0\""));
}

TEST_F(Command, anHourglassIsCutAtItsNeck) {
  const std::string model = write("hourglass.obj", hourglass());
  const Outcome whole = run({"cut", model, "--neck", "0", "--json"});
  ASSERT_EQ(whole.exitCode, 0) << whole.errors;
  const Json parts = Json::parse(whole.output)["parts"];
  ASSERT_EQ(parts.size(), 2u);
  for (const Json& part : parts) {
    EXPECT_EQ(part["faces"], 12);
    EXPECT_EQ(part["boundaries"], 2);
    EXPECT_TRUE(part["volume"].is_null());
  }
  const Json neck = Json::parse(run({"necks", model, "--json"}).output)["necks"][0];
  ASSERT_EQ(neck["sides"].size(), 2u);
  EXPECT_NEAR(neck["sides"][0]["area"], parts[0]["area"], 1e-9);

  // The loop at a vertex of the neck is the neck. Caps have four triangles.
  ASSERT_EQ(run({"cut", model, "6", "--cap", "-o", path("parts.obj")}).exitCode, 0);
  const std::string obj = contentOf(path("parts.obj"));
  EXPECT_TRUE(contains(obj, "o part_0\n") && contains(obj, "o part_1\n"));
  EXPECT_TRUE(contains(run({"info", path("parts.obj"), "--component", "0"}).output, "16 faces"));
  ASSERT_EQ(run({"cut", model, "--necks", "-o", path("parts.glb")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("parts.glb")), "\"part_1\""));
  ASSERT_EQ(run({"cut", model, "--necks", "-o", path("parts.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("parts.csv")));
  ASSERT_EQ(rows.size(), 25u);
  EXPECT_EQ(rows[0], "face,part");
  EXPECT_NE(rows[1].back(), rows[24].back());
}

TEST_F(Command, whatCannotBeCutIsNamed) {
  const std::string model = write("hourglass.obj", hourglass());
  const auto refused = [&](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.begin(), {"cut", model});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << outcome.errors;
  };
  refused({}, "no loop is named");
  refused({"99"}, "there is no vertex 99; its vertices are numbered from 0 to 17");
  refused({"-1"}, "");
  refused({"--neck", "2"}, "there is no neck 2; necks are numbered from 0 to 0");
  refused({"--neck=-1"}, "there is no neck -1");
  const Outcome beyond = run({"cut", model, "--at", "100", "-o", path("uncut.obj")});
  EXPECT_EQ(beyond.exitCode, 2) << beyond.errors;
  EXPECT_TRUE(contains(beyond.errors,
                       "VALUE_OUT_OF_RANGE: the girth is nowhere 100: it goes from 6 to 10.3"))
      << beyond.errors;
  EXPECT_FALSE(fs::exists(path("uncut.obj")));
  // No neck at all: nothing to cut, and one part.
  const Json parts =
      Json::parse(run({"cut", kData + "/prism.obj", "--necks", "--json"}).output)["parts"];
  EXPECT_EQ(parts.size(), 1u);
}

TEST_F(Command, noNeckIsAnAnswerInEveryFormat) {
  const std::string model = kData + "/prism.obj";
  EXPECT_TRUE(contains(run({"necks", model}).output, "no necks\n"));
  for (const std::string name : {"none.json", "none.csv", "none.obj", "none.glb"}) {
    const Outcome outcome = run({"necks", model, "-o", path(name)});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  }
  EXPECT_EQ(Json::parse(contentOf(path("none.json")))["necks"], Json::array());
  EXPECT_EQ(linesOf(contentOf(path("none.csv"))).size(), 1u);
  EXPECT_EQ(contentOf(path("none.obj")), "");
  // An empty scene, without the members that may not be empty.
  const std::string glb = contentOf(path("none.glb"));
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  const Json scene = Json::parse(glb.substr(20, glb.find_last_of('}') - 19));
  EXPECT_EQ(scene["asset"]["version"], "2.0");
  for (const char* member : {"buffers", "meshes", "nodes", "accessors", "bufferViews"}) {
    EXPECT_FALSE(scene.contains(member)) << member;
  }
}

TEST_F(Command, necksOfAProminence) {
  const std::string model = write("hourglass.obj", hourglass());
  EXPECT_TRUE(contains(run({"necks", model, "--min-prominence", "0"}).output, "1 neck\n"));
  EXPECT_TRUE(contains(run({"necks", model, "--unit", "cm", "--min-prominence", "20mm"}).output,
                       "1 neck\n"));
  // The one neck is clear: nothing is left out, and no note says so.
  EXPECT_EQ(run({"necks", model}).output, run({"necks", model, "--min-prominence", "0"}).output);
  EXPECT_EQ(run({"necks", model}).errors, "");
  for (const std::string length : {"-1", "nan", "wide", ""}) {
    const Outcome outcome = run({"necks", model, "--min-prominence", length});
    EXPECT_EQ(outcome.exitCode, 1) << length;
    EXPECT_TRUE(contains(outcome.errors, "USAGE")) << outcome.errors;
  }
}

}  // namespace
}  // namespace girth::test
