// girth section, on a box of known sections.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A box of 2 by 3 by 4.
std::string box() {
  return "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

TEST_F(Command, sectionsOfABox) {
  const std::string model = write("box.obj", box());
  const Outcome outcome = run({"section", model, "--unit", "cm", "--at-height", "10mm",
                               "--at-height", "4", "-o", path("s.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("s.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  EXPECT_EQ(all["unit"], "centimetre");
  ASSERT_EQ(all["sections"].size(), 2u);
  for (const Json& section : all["sections"]) {
    EXPECT_EQ(section["normal"], Json({0, 0, 1}));
    EXPECT_NEAR(section["perimeter"].get<double>(), 10, 1e-12);
    EXPECT_NEAR(section["area"].get<double>(), 6, 1e-12);
    ASSERT_EQ(section["curves"].size(), 1u);
    EXPECT_EQ(section["curves"][0]["points"].front(), section["curves"][0]["points"].back());
  }
  EXPECT_EQ(all["sections"][0]["offset"], 1);
  EXPECT_TRUE(contains(run({"section", model, "--levels", "3"}).output, "3 sections\n"));

  ASSERT_EQ(run({"section", model, "--every", "1.5", "-o", path("s.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("s.csv")));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].rfind("0,1.5,0,,10,10,6,", 0), 0u) << rows[1];
  ASSERT_EQ(run({"section", model, "--through", "2", "--along", "x", "-o", path("s.obj")}).exitCode,
            0);
  EXPECT_TRUE(contains(contentOf(path("s.obj")), "l 1 2 3 4 1\n"));
  ASSERT_EQ(run({"section", model, "-o", path("s.glb")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("s.glb")), "\"section_0_curve_0\""));
}

TEST_F(Command, planesThatMissAreToldTheRange) {
  const std::string model = write("box.obj", box());
  const auto refused = [&](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.begin(), {"section", model});
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_TRUE(contains(outcome.errors, words)) << outcome.errors;
  };
  refused({"--at-height", "9"}, "reaches from 0 to 4");
  refused({"--at-height", "-9"}, "reaches from 0 to 4");
  refused({"--at-height", "--9"}, "is not a length");
  refused({"--along", "0,-1,0", "--at-height", "1"}, "reaches from -3 to 0");
  refused({"--along", "up"}, "a direction is x, y, z");
  refused({"--along", "0,0,0"}, "no direction");
  refused({"--every", "0"}, "above 0");
  refused({"--every", "1e-9"}, "more than 100000 planes");
  refused({"--at-height", "2mm"}, "unit");
  refused({"--through", "99"}, "VERTEX_OUT_OF_RANGE");
}

/// A box of 2 by 3 with one of 1 by 1 on it, each 4 high.
std::string boxWithChimney() {
  return box() +
         "v 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\nv 0 0 9\nv 1 0 9\nv 1 1 9\nv 0 1 9\n"
         "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";
}

TEST_F(Command, theWidestAndTheNarrowestSectionAreFound) {
  const std::string model = write("bodies.obj", boxWithChimney());
  const auto sectionOf = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"section", model, "--json", "--unit", "m"});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output)["sections"].at(0);
  };
  EXPECT_EQ(sectionOf({"--widest"})["perimeter"], 10);
  EXPECT_EQ(sectionOf({"--narrowest", "--within", "0,7m"})["perimeter"], 4);
  EXPECT_EQ(sectionOf({"--narrowest", "--within", "100cm,350cm", "--by-tape"})["tape"], 10);
  EXPECT_NE(run({"section", model, "--narrowest"}).exitCode, 0);
  EXPECT_TRUE(contains(run({"section", model, "--widest", "--within", "3"}).errors, "no range"));
  EXPECT_TRUE(contains(run({"section", model, "--widest", "--within", "20,30"}).errors,
                       "no plane of the range"));
}

TEST_F(Command, oneTapeGoesOverAllCurvesWhereAskedFor) {
  const std::string model =
      write("bodies.obj", boxWithChimney() +
                              "v 8 0 0\nv 9 0 0\nv 8 1 0\nv 8 0 4\n"
                              "f 17 19 18\nf 17 18 20\nf 18 19 20\nf 19 17 20\n");
  const Outcome outcome = run({"section", model, "--at-height", "2", "--tape-over", "all"});
  EXPECT_TRUE(contains(outcome.output, "curves")) << outcome.output;
  ASSERT_EQ(run({"section", model, "--at-height", "2", "--tape-over", "all", "-o", path("s.csv")})
                .exitCode,
            0);
  const auto rows = linesOf(contentOf(path("s.csv")));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], "section,offset,curves,perimeter,tape,area,unit");
  EXPECT_TRUE(contains(run({"section", model, "--tape-over", "some"}).errors, "over each curve"));
}

TEST_F(Command, inscribedCirclesAndLimbsWhereAskedFor) {
  const std::string model = write("box.obj", box());
  const auto curveOf = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"section", model, "--json"});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output)["sections"].at(0)["curves"].at(0);
  };
  EXPECT_TRUE(curveOf({})["inscribedDiameter"].is_null());
  EXPECT_EQ(curveOf({"--inscribed"})["inscribedDiameter"], 2);
  EXPECT_TRUE(contains(run({"section", model, "--inscribed"}).output, "(circle 2)"));
  EXPECT_TRUE(curveOf({"--limbs"}).contains("limb"));
}

TEST_F(Command, aSectionAcrossATube) {
  // A square tube along x, 1 by 1 by 8, in eight rings.
  std::string obj;
  for (int ring = 0; ring <= 8; ++ring) {
    for (const char* corner : {"0 0", "1 0", "1 1", "0 1"}) {
      obj += "v " + std::to_string(ring) + " " + corner + "\n";
    }
  }
  for (int ring = 0; ring < 8; ++ring) {
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * ring + k + 1, b = 4 * ring + (k + 1) % 4 + 1;
      obj += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(b + 4) +
             " " + std::to_string(a + 4) + "\n";
    }
  }
  obj += "f 4 3 2 1\nf 33 34 35 36\n";
  const std::string model = write("tube.obj", obj);
  EXPECT_EQ(run({"section", model, "--along", "-x", "--at-height", "-3"}).exitCode, 0);
  EXPECT_EQ(run({"section", model, "--along", "-x", "--widest", "--within", "-3,-2"}).exitCode, 0);
  const Outcome outcome = run({"section", model, "--through", "16", "--across", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json section = Json::parse(outcome.output)["sections"].at(0);
  EXPECT_NEAR(std::abs(section["normal"][0].get<double>()), 1, 1e-12);
  EXPECT_NEAR(section["perimeter"].get<double>(), 4, 1e-12);
  EXPECT_NEAR(std::abs(section["offset"].get<double>()), 4, 1e-12);
  EXPECT_NE(run({"section", model, "--across"}).exitCode, 0);
}

TEST_F(Command, namedMeasuresAtLandmarksOfAFile) {
  const std::string model = write("box.obj", box());
  // Vertex 4 lies above vertex 0; face 4 is on the front, 0 1 5.
  const std::string file = write(
      "landmarks.json",
      "[{\"name\":\"waist, back\",\"point\":\"4:0.25,0.25,0.5\",\"how\":\"section\"},"
      "{\"name\":\"waist\",\"point\":\"4:0.25,0.25,0.5\",\"how\":\"tape\"},"
      "{\"name\":\"height\",\"point\":0,\"to\":4,\"how\":\"distance\"},"
      "{\"name\":\"loop\",\"point\":\"4:0.25,0.25,0.5\",\"how\":\"girth\"},"
      "{\"name\":\"round\",\"point\":\"4:0.25,0.25,0.5\",\"how\":\"section\",\"across\":true}]");
  const Outcome outcome =
      run({"section", model, "--landmarks", file, "-o", path("m.csv"), "--unit", "cm", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json measures = Json::parse(outcome.output)["measures"];
  ASSERT_EQ(measures.size(), 5u);
  EXPECT_NEAR(measures[0]["length"].get<double>(), 10, 1e-12);
  EXPECT_NEAR(measures[1]["length"].get<double>(), 10, 1e-12);
  EXPECT_NEAR(measures[2]["length"].get<double>(), 4, 1e-12);
  EXPECT_EQ(measures[2]["point"]["vertices"], Json({0}));
  const Json loop =
      Json::parse(run({"loop", model, "--face", "4", "--at", "0.25,0.25,0.5", "--json"}).output);
  EXPECT_EQ(measures[3]["length"], loop["length"]);
  EXPECT_GT(measures[4]["length"].get<double>(), 0);
  const auto rows = linesOf(contentOf(path("m.csv")));
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], "number,name,how,x,y,z,length,unit");
  EXPECT_EQ(rows[1].rfind("0,\"waist, back\",section,", 0), 0u) << rows[1];
  EXPECT_EQ(rows[3].rfind("2,height,distance,0,0,0,", 0), 0u) << rows[3];
  EXPECT_TRUE(contains(run({"section", model, "--landmarks", file}).output, "5 measures\n"));
  EXPECT_NE(run({"section", model, "--landmarks", file, "-o", path("m.obj")}).exitCode, 0);
}

TEST_F(Command, landmarksThatAreNoneAreNamed) {
  const std::string model = write("box.obj", box());
  const auto refusal = [&](const std::string& content) {
    const Outcome outcome =
        run({"section", model, "--landmarks", write("landmarks.json", content)});
    EXPECT_NE(outcome.exitCode, 0);
    return outcome.errors;
  };
  EXPECT_TRUE(contains(refusal("{"), "no JSON array"));
  EXPECT_TRUE(contains(refusal("[{\"point\":1}]"), "landmark 0 has no \"name\""));
  EXPECT_TRUE(contains(refusal("[{\"name\":\"a\",\"point\":1,\"how\":\"width\"}]"),
                       "landmark 0 (a) has no \"how\""));
  EXPECT_TRUE(
      contains(refusal("[{\"name\":\"a\",\"point\":1,\"how\":\"distance\"}]"), "has no \"to\""));
  EXPECT_TRUE(contains(refusal("[{\"name\":\"neck\",\"point\":99,\"how\":\"tape\"}]"), "neck: "));
}

}  // namespace
}  // namespace girth::test
