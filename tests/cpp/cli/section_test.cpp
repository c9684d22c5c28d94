// girth section, on a box of known sections.
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
  EXPECT_EQ(rows[1].rfind("0,1.5,0,10,10,6,", 0), 0u) << rows[1];
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
  refused({"--along", "0,-1,0", "--at-height", "1"}, "reaches from -3 to 0");
  refused({"--along", "up"}, "a direction is x, y, z");
  refused({"--along", "0,0,0"}, "no direction");
  refused({"--every", "0"}, "above 0");
  refused({"--every", "1e-9"}, "more than 100000 planes");
  refused({"--at-height", "2mm"}, "unit");
  refused({"--through", "99"}, "VERTEX_OUT_OF_RANGE");
}

}  // namespace
}  // namespace girth::test
