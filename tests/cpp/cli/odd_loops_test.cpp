// Answers of necks, handles, bottlenecks, profiles and cuts where there is little to find: open
// surfaces, several components, surfaces that cannot be oriented, two necks that touch, and odd
// thresholds.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, boundariesAreNoHandles) {
  // An open hourglass has genus 0, whatever its two ends are.
  const std::string model = write("hourglass.obj", hourglass());
  EXPECT_TRUE(contains(run({"handles", model}).output, "no handles: its genus is 0\n"));
  // A frame without one of its faces keeps its two loops.
  std::string open = frame();
  open.erase(open.rfind("f "));
  const Json handles =
      Json::parse(run({"handles", write("open.obj", open), "--json"}).output)["handles"];
  EXPECT_EQ(handles.size(), 2u);
}

TEST_F(Command, everyComponentCountsByItself) {
  const std::string model = write("two.obj", hourglass() + hourglass(20, kHourglassVertices));
  const Json necks = Json::parse(run({"necks", model, "--json"}).output)["necks"];
  ASSERT_EQ(necks.size(), 2u);
  for (const Json& neck : necks) EXPECT_TRUE(neck["prominence"].is_null());
  EXPECT_EQ(Json::parse(run({"cut", model, "--necks", "--json"}).output)["parts"].size(), 4u);
  EXPECT_EQ(Json::parse(run({"cut", model, "--neck", "0", "--json"}).output)["parts"].size(), 3u);
  EXPECT_EQ(Json::parse(run({"bottleneck", model, "18", "33", "--json"}).output)["kind"], "neck");
}

TEST_F(Command, whatCannotBeOrientedIsCutApartAndSaid) {
  // A Möbius strip of eight quadrilaterals.
  std::string strip;
  for (int i = 0; i < 8; ++i) {
    const double turn = 2 * M_PI * i / 8, twist = turn / 2;
    for (const double side : {-0.3, 0.3}) {
      const double out = 2 + side * std::cos(twist);
      strip += "v " + std::to_string(out * std::cos(turn)) + " " +
               std::to_string(out * std::sin(turn)) + " " + std::to_string(side * std::sin(twist)) +
               "\n";
    }
  }
  for (int i = 0; i < 8; ++i) {
    const int a = 2 * i + 1, b = a + 1;
    const int c = i == 7 ? 2 : a + 2, d = i == 7 ? 1 : b + 2;
    strip += "f " + std::to_string(a) + " " + std::to_string(c) + " " + std::to_string(d) + " " +
             std::to_string(b) + "\n";
  }
  const std::string model = write("strip.obj", strip);
  EXPECT_GT(Json::parse(run({"info", model, "--json"}).output)["report"]["oneSidedEdges"], 0);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"necks", model},
                                                {"handles", model},
                                                {"bottleneck", model, "0", "8"},
                                                {"profile", model, "0", "8"},
                                                {"segments", model},
                                                {"igf", model},
                                                {"loop", model, "0"},
                                                {"tips", model},
                                                {"limbs", model},
                                                {"parts", model},
                                                {"field", model, "--field", "angle"},
                                                {"cut", model, "--necks"}}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exitCode, 0) << words[0] << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, "note: the surface has one side only and was cut along "))
        << words[0] << outcome.errors;
  }
}

TEST_F(Command, cracksAreNamedByEveryCommandAndSewn) {
  // A tetrahedron, one facet of which differs by a rounding; and one that is divided.
  const std::string a = "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nv 0 0 0.3\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  const std::string b = "0.30000000000000004";
  const std::string facet = "v " + b + " 0 0\nv 0 " + b + " 0\nv 0 0 " + b + "\n";
  const std::string rounded = write("rounded.obj", a + facet + "f 5 6 7\n");
  const std::string divided = write("divided.obj", a + "v 0.1 0.2 0\nf 2 5 4\nf 5 3 4\n");
  for (const std::string& model : {rounded, divided}) {
    const std::string what = model == rounded
                                 ? "3 boundary vertices nearly coincide with others"
                                 : "1 boundary vertex lies within the edge of a neighbour";
    for (const std::vector<std::string>& words : {std::vector<std::string>{"igf", model},
                                                  {"loop", model, "1"},
                                                  {"tips", model},
                                                  {"parts", model},
                                                  {"cut", model, "--necks"}}) {
      EXPECT_TRUE(contains(run(words).errors, what)) << words[0];
    }
    EXPECT_TRUE(contains(run({"info", model}).output, what));
    // On open facets no loop runs round the body.
    const Outcome corner = run({"profile", rounded, "1", "2"});
    EXPECT_TRUE(contains(corner.output, ", antipodal: no loop there")) << corner.output;
    const Json report = Json::parse(run({"info", model, "--json"}).output)["report"];
    EXPECT_EQ(report["crackVertices"], model == rounded ? 3 : 0);
    EXPECT_EQ(report["tJunctions"], model == rounded ? 0 : 1);
    const Outcome sewn = run({"info", model, "--json", "--weld", report["crackWidth"].dump()});
    EXPECT_EQ(Json::parse(sewn.output)["report"]["boundaryCurves"], 0);
    EXPECT_NEAR(Json::parse(sewn.output)["area"].get<double>(), 0.212942286, 1e-9);
    if (model == divided) {
      const Outcome onDivided = run({"profile", model, "0:0.2,0.3,0.5", "0", "--close-holes"});
      EXPECT_TRUE(contains(onDivided.errors, "face 0 was divided")) << onDivided.errors;
    }
    const Outcome filled = run({"info", model, "--json", "--close-holes"});
    EXPECT_EQ(Json::parse(filled.output)["report"]["closedHoles"], 0);
    EXPECT_EQ(Json::parse(filled.output)["report"]["boundaryCurves"], 0);
  }
}

TEST_F(Command, twoNecksThatTouchAreCutBoth) {
  // A torus of few sections: two neighbouring loops round the tube meet at its inside.
  std::string model;
  constexpr int kAround = 7, kAcross = 6;
  for (int k = 0; k < kAround; ++k) {
    for (int i = 0; i < kAcross; ++i) {
      const double u = 2 * M_PI * k / kAround, v = 2 * M_PI * i / kAcross;
      model += "v " + std::to_string((4 + std::cos(v)) * std::cos(u)) + " " +
               std::to_string((4 + std::cos(v)) * std::sin(u)) + " " + std::to_string(std::sin(v)) +
               "\n";
    }
  }
  for (int k = 0; k < kAround; ++k) {
    for (int i = 0; i < kAcross; ++i) {
      const int a = k * kAcross + i, b = (k + 1) % kAround * kAcross + i;
      const int c = (k + 1) % kAround * kAcross + (i + 1) % kAcross,
                d = k * kAcross + (i + 1) % kAcross;
      for (const int corners : {0, 1}) {
        model += "f " + std::to_string(a + 1) + " " + std::to_string((corners == 0 ? b : c) + 1) +
                 " " + std::to_string((corners == 0 ? c : d) + 1) + "\n";
      }
    }
  }
  const std::string file = write("torus.obj", model);
  const std::size_t necks =
      Json::parse(run({"necks", file, "--min-prominence", "0", "--json"}).output)["necks"].size();
  EXPECT_GE(necks, 2u);
  const Outcome outcome = run({"cut", file, "--necks", "--min-prominence", "0", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(Json::parse(outcome.output)["parts"].size(), necks);
}

TEST_F(Command, oddThresholds) {
  const std::string model = write("frame.obj", frame());
  for (const std::string length : {"-1", "nan", "-0.5mm", "wide"}) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"necks", model, "--min-prominence", length},
          {"cut", model, "--necks", "--min-prominence", length},
          {"cut", model, "--at", length},
          {"remesh", model, "--remove-handles", length, "-o", path("r.obj")}}) {
      const Outcome outcome = run(words);
      EXPECT_EQ(outcome.exitCode, 1) << words[0] << " " << length;
      EXPECT_TRUE(contains(outcome.errors, model)) << outcome.errors;
    }
  }
  // A threshold of 0 takes all necks, and removes no handle.
  EXPECT_EQ(run({"necks", model, "--min-prominence", "0"}).exitCode, 0);
  const Outcome none =
      run({"remesh", model, "--remove-handles", "0", "-o", path("same.obj"), "--json"});
  ASSERT_EQ(none.exitCode, 0) << none.errors;
  EXPECT_EQ(Json::parse(none.output)["genus"], 1);
}

}  // namespace
}  // namespace girth::test
