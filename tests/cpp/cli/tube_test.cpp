// girth tube, on a tube with a narrowing.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// An open tube of radius 1 along z, 16 long, half as wide in the middle, with 16 corners.
std::string narrowTube() {
  constexpr int kRings = 33, kCorners = 16;
  std::string text;
  for (int i = 0; i < kRings; ++i) {
    const double z = i * 0.5, x = std::fabs(z - 8) / 2;
    const double r = x < 1 ? 1 - (1 + std::cos(std::numbers::pi * x)) / 4 : 1;
    for (int j = 0; j < kCorners; ++j) {
      const double angle = 2 * std::numbers::pi * j / kCorners;
      text += "v " + std::to_string(r * std::cos(angle)) + " " +
              std::to_string(r * std::sin(angle)) + " " + std::to_string(z) + "\n";
    }
  }
  const auto at = [](int i, int j) { return std::to_string(i * kCorners + j % kCorners + 1); };
  for (int i = 0; i + 1 < kRings; ++i) {
    for (int j = 0; j < kCorners; ++j) {
      text += "f " + at(i, j) + " " + at(i, j + 1) + " " + at(i + 1, j + 1) + "\n";
      text += "f " + at(i, j) + " " + at(i + 1, j + 1) + " " + at(i + 1, j) + "\n";
    }
  }
  return text;
}

TEST_F(Command, tubesHaveTheirNarrowings) {
  const std::string model = write("tube.obj", narrowTube());
  const Outcome outcome = run({"tube", model, "--unit", "mm", "-o", path("tube.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("tube.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  ASSERT_EQ(all["branches"].size(), 1u);
  EXPECT_TRUE(all["branches"][0]["open"].get<bool>());
  EXPECT_TRUE(all["branches"][0]["parent"].is_null());
  ASSERT_EQ(all["places"].size(), 1u);
  EXPECT_EQ(all["places"][0]["change"], "narrowing");
  EXPECT_NEAR(all["places"][0]["degreeByDiameter"].get<double>(), 0.5, 0.01);
  EXPECT_GT(all["stations"].size(), 40u);
  EXPECT_TRUE(all["others"].empty());
  const std::string words = run({"tube", model}).output;
  EXPECT_TRUE(contains(words, "1 branch, 1 narrowing or widening\n")) << words;
  EXPECT_TRUE(contains(words, "50.0%")) << words;
}

TEST_F(Command, tubesAreWrittenInEachForm) {
  const std::string model = write("tube.obj", narrowTube());
  ASSERT_EQ(run({"tube", model, "--no-girth", "-o", path("s.csv")}).exitCode, 0);
  const auto stations = linesOf(contentOf(path("s.csv")));
  EXPECT_EQ(stations[0],
            "number,branch,distance,equivalentDiameter,area,perimeter,inscribedDiameter,leastWidth,"
            "greatestWidth,girth,curvature,torsion,x,y,z,directionX,directionY,directionZ,placeX,"
            "placeY,placeZ,unit");
  EXPECT_GT(stations.size(), 40u);
  ASSERT_EQ(run({"tube", model, "--places", "-o", path("p.csv")}).exitCode, 0);
  const auto places = linesOf(contentOf(path("p.csv")));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0],
            "number,change,branch,distance,beforeDistance,beyondDistance,length,"
            "equivalentDiameter,reference,degreeByDiameter,degreeByArea,beforeDiameter,"
            "beyondDiameter,area,perimeter,inscribedDiameter,leastWidth,girth,x,y,z,unit");
  EXPECT_EQ(places[1].rfind("0,narrowing,0,", 0), 0u);
  ASSERT_EQ(run({"tube", model, "-o", path("t.obj")}).exitCode, 0);
  const std::string lines = contentOf(path("t.obj"));
  EXPECT_TRUE(contains(lines, "o branch_0\n"));
  EXPECT_TRUE(contains(lines, "o place_0\n"));
  ASSERT_EQ(run({"tube", model, "-o", path("t.glb")}).exitCode, 0);
  EXPECT_EQ(contentOf(path("t.glb")).substr(0, 4), "glTF");
  ASSERT_EQ(run({"tube", model, "--unit", "mm", "-o", path("t.html")}).exitCode, 0);
  const std::string page = contentOf(path("t.html"));
  EXPECT_TRUE(contains(page, "<!doctype html>"));
  EXPECT_TRUE(contains(page, "Lengths are in mm."));
  EXPECT_TRUE(contains(page, "<td>narrowing</td>"));
  EXPECT_TRUE(contains(page, "0: 50.0%"));
  EXPECT_FALSE(contains(page, "http"));
}

TEST_F(Command, referencesOfTubes) {
  const std::string model = write("tube.obj", narrowTube());
  const auto degreeBy = [&](const std::string& reference) {
    const Outcome outcome =
        run({"tube", model, "--ends", "0,527", "--reference", reference, "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output)["places"][0]["degreeByDiameter"].get<double>();
  };
  for (const std::string reference : {"taper", "mean", "beyond", "before"}) {
    EXPECT_NEAR(degreeBy(reference), 0.5, 0.01) << reference;
  }
  EXPECT_TRUE(contains(run({"tube", model, "--min-degree", "60"}).output, "0 narrowings"));
}

TEST_F(Command, tubesThatAreNoneAreSaid) {
  const std::string cube =
      write("cube.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
            "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Outcome outcome = run({"tube", cube, "-o", path("cube.html")});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.output, "component 0 is no tube: it is less than 2.5 times"));
  EXPECT_TRUE(contains(contentOf(path("cube.html")), "Component 0 is less than 2.5 times"));
  EXPECT_TRUE(contains(run({"tube", cube, "--places"}).errors, "--places needs a table"));
  EXPECT_EQ(run({"tube", cube, "--ends", "99"}).exitCode, 1);
  EXPECT_TRUE(contains(run({"tube", cube, "--every", "0.5mm"}).errors, "unit"));
  EXPECT_TRUE(contains(run({"tube", cube, "--every", "0"}).errors, "above 0"));
}

}  // namespace
}  // namespace girth::test
