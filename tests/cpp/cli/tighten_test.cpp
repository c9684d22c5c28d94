// girth tighten, on a square prism that is open at its ends.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A prism of sides of length 1, with nine rings of four corners. Vertex (ring, corner) has the
/// number 4 × ring + corner.
std::string squarePrism() {
  constexpr int kRings = 9;
  std::string text;
  for (int i = 0; i < kRings; ++i) {
    const std::string z = std::to_string(i);
    text += "v 0 0 " + z + "\nv 1 0 " + z + "\nv 1 1 " + z + "\nv 0 1 " + z + "\n";
  }
  const auto at = [](int i, int j) { return std::to_string(4 * i + j % 4 + 1); };
  for (int i = 0; i + 1 < kRings; ++i) {
    for (int j = 0; j < 4; ++j) {
      text += "f " + at(i, j) + " " + at(i, j + 1) + " " + at(i + 1, j + 1) + "\n";
      text += "f " + at(i, j) + " " + at(i + 1, j + 1) + " " + at(i + 1, j) + "\n";
    }
  }
  return text;
}

TEST_F(Command, curvesAreDrawnTight) {
  const std::string model = write("prism.obj", squarePrism());
  // Once round and four rings up.
  const std::string points = "8,9,10,11,8,12,16,20,24";
  const Outcome outcome = run(
      {"tighten", model, "--along", points, "--unit", "mm", "-o", path("tight.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("tight.json")), outcome.output);
  const Json tight = Json::parse(outcome.output);
  EXPECT_EQ(tight["kind"], "path");
  EXPECT_EQ(tight["promise"], "shortest");
  EXPECT_EQ(tight["lengthBefore"], 8);
  EXPECT_NEAR(tight["length"].get<double>(), std::sqrt(32.0), 1e-12);
  EXPECT_EQ(tight["points"].front()["vertices"], Json::array({8}));
  EXPECT_EQ(tight["points"].back()["vertices"], Json::array({24}));
  // Its own file is a curve too.
  const Json again =
      Json::parse(run({"tighten", model, "--along", path("tight.json"), "--json"}).output);
  EXPECT_NEAR(again["length"].get<double>(), std::sqrt(32.0), 1e-12);
  const std::string words = run({"tighten", model, "--along", points, "--unit", "mm"}).output;
  EXPECT_TRUE(contains(words, "length   5.65685 mm\n")) << words;
  EXPECT_TRUE(contains(words, "promise  shortest of its homotopy class\n")) << words;
  const Json closed =
      Json::parse(run({"tighten", model, "--along", "12,17,14,19", "--closed", "--json"}).output);
  EXPECT_EQ(closed["kind"], "loop");
  EXPECT_NEAR(closed["length"].get<double>(), 4, 1e-12);
  const std::string point =
      run({"tighten", model, "--along", "12,13,17", "--closed", "-o", path("p.obj")}).output;
  EXPECT_TRUE(contains(point, "kind     point: ")) << point;
  EXPECT_EQ(contentOf(path("p.obj")), "# the curve contracts to a point\n");
  const std::string fixed =
      run({"tighten", model, "--along", "8,10,24", "--fixed", "-o", path("pieces.csv")}).output;
  EXPECT_TRUE(contains(fixed, "piece 1 ")) << fixed;
  const auto rows = linesOf(contentOf(path("pieces.csv")));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "number,lengthBefore,length,promise,x,y,z,endX,endY,endZ,unit");
  EXPECT_EQ(rows[1], "0,2,2,shortest,0,0,2,1,1,2,");
}

TEST_F(Command, tightCurvesComeFromFiles) {
  const std::string model = write("prism.obj", squarePrism());
  // A line in space, of two elements: round at z = 2.5 and on to where it began.
  const std::string line = write(
      "line.obj", "v 0.5 0 2.5\nv 1 0.5 2.25\nv 0.5 1 2.5\nv 0 0.5 2.75\nl 1 2 3\nl 3 4\n# end\n");
  const Outcome outcome =
      run({"tighten", model, "--along", line, "--closed", "-o", path("loop.glb"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NEAR(Json::parse(outcome.output)["length"].get<double>(), 4, 1e-12);
  EXPECT_TRUE(contains(contentOf(path("loop.glb")), "\"promise\":\"shortest\""));
  // The written line is read back.
  ASSERT_EQ(run({"tighten", model, "--along", line, "--closed", "-o", path("loop.obj")}).exitCode,
            0);
  const Outcome back = run({"tighten", model, "--along", path("loop.obj"), "--closed", "--json"});
  EXPECT_NEAR(Json::parse(back.output)["lengthBefore"].get<double>(), 4, 1e-9);
  const std::string pairs = write("pairs.csv", "8,18\n12,20\n");
  ASSERT_EQ(run({"distance", model, "--between", pairs, "--paths", "-o", path("d.json")}).exitCode,
            0);
  EXPECT_NE(run({"tighten", model, "--along", path("d.json")}).exitCode, 0) << "it has two";
  const Outcome second =
      run({"tighten", model, "--along", path("d.json"), "--curve", "1", "--json"});
  EXPECT_NEAR(Json::parse(second.output)["length"].get<double>(), 2, 1e-12);
  ASSERT_EQ(run({"cut", model, "--along", path("loop.obj"), "-o", path("parts.glb")}).exitCode, 0);
}

TEST_F(Command, curvesThatCannotBeDrawnTightSayWhy) {
  const std::string model = write("prism.obj", squarePrism());
  const auto errorOf = [&](const std::string& along, const std::string& more = {}) {
    std::vector<std::string> words{"tighten", model, "--along", along};
    if (!more.empty()) words.insert(words.end(), {"--curve", more});
    const Outcome outcome = run(words);
    EXPECT_NE(outcome.exitCode, 0) << along;
    return outcome.errors;
  };
  EXPECT_TRUE(contains(errorOf("0,999"), "VERTEX_OUT_OF_RANGE"));
  EXPECT_TRUE(contains(errorOf("here"), "--along"));
  EXPECT_TRUE(contains(errorOf("0,1", "0"), "--curve needs a file"));
  EXPECT_TRUE(contains(errorOf(path("none.obj")), "FILE_NOT_FOUND"));
  EXPECT_TRUE(contains(errorOf(write("off.obj", "v 0 0 1\nv 9 9 9\n")), "INVALID_POINT"));
  EXPECT_TRUE(contains(errorOf(write("bad.obj", "v 0 0 1\nl 1 2\n")), "line 2"));
  EXPECT_TRUE(contains(errorOf(write("word.obj", "v 0 zero 1\n")), "line 1"));
  EXPECT_TRUE(contains(errorOf(write("empty.obj", "")), "MALFORMED_FILE"));
  EXPECT_TRUE(contains(errorOf(write("bad.json", "{}")), "MALFORMED_FILE"));
  const std::string two =
      write("two.obj", squarePrism() + "v 9 9 9\nv 10 9 9\nv 9 10 9\nf 37 38 39\n");
  const Outcome apart = run({"tighten", two, "--along", "0,36"});
  EXPECT_TRUE(contains(apart.errors, "different components")) << apart.errors;
}

}  // namespace
}  // namespace girth::test
