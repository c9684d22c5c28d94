// girth handles, on a square frame of known loops.
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, handlesOfAFrame) {
  const std::string model = write("frame.obj", frame());
  const Outcome outcome =
      run({"handles", model, "--unit", "cm", "-o", path("handles.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("handles.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  EXPECT_EQ(all["unit"], "centimetre");
  EXPECT_EQ(all["unresolved"], 0);
  ASSERT_EQ(all["handles"].size(), 2u);
  EXPECT_EQ(all["handles"][0]["kind"], "handle");
  EXPECT_NEAR(all["handles"][0]["length"].get<double>(), 3, 1e-9);
  EXPECT_EQ(all["handles"][0]["mayBeShorterBy"], 0);
  EXPECT_EQ(all["handles"][1]["kind"], "tunnel");
  EXPECT_NEAR(all["handles"][1]["length"].get<double>(), 4, 1e-9);
  EXPECT_NEAR(all["handles"][1]["area"].get<double>(), 1, 1e-9);
  for (const Json& handle : all["handles"]) {
    EXPECT_EQ(handle["points"].front(), handle["points"].back());
  }
  EXPECT_TRUE(contains(run({"handles", model}).output, "genus 1\n"));
  EXPECT_EQ(run({"handles", model, "--all-vertices", "--unit", "cm", "--json"}).output,
            outcome.output);

  ASSERT_EQ(run({"handles", model, "-o", path("handles.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("handles.csv")));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[2].rfind("1,4,tunnel,0,1,", 0), 0u) << rows[2];
  ASSERT_EQ(run({"handles", model, "-o", path("handles.obj")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("handles.obj")), "o tunnel_1\n"));
  ASSERT_EQ(run({"handles", model, "-o", path("handles.glb")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("handles.glb")), "\"handle_0\""));
}

TEST_F(Command, handlesAreRemovedUpToALength) {
  const std::string model = write("frame.obj", frame());
  const auto removed = [&](const std::string& length) {
    const Outcome outcome = run({"remesh", model, "--unit", "cm", "--remove-handles", length, "-o",
                                 path("repaired.obj"), "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output);
  };
  Json kept = removed("29mm");
  EXPECT_EQ(kept["genusBefore"], 1);
  EXPECT_EQ(kept["genus"], 1);
  EXPECT_EQ(kept["faces"], kept["facesBefore"]);
  EXPECT_EQ(kept["provenLength"], 2.9);
  EXPECT_EQ(kept["removed"], Json::array());
  Json made = removed("31mm");
  EXPECT_EQ(made["genus"], 0);
  EXPECT_EQ(made["genusAfter"], 0);
  ASSERT_EQ(made["removed"].size(), 1u);
  EXPECT_LT(made["removed"][0]["length"], 3.1);
  EXPECT_EQ(made["removed"][0]["centre"].size(), 3u);
  EXPECT_EQ(Json::parse(run({"info", path("repaired.obj"), "--json"}).output)["genus"], Json({0}));
  EXPECT_TRUE(
      contains(run({"remesh", model, "--remove-handles", "4", "-o", path("repaired.obj")}).output,
               "genus 0 (before: 1): 0 handles dropped, 1 handle cut, 0 tunnels filled, 0 tunnels "
               "closed\n"));
  for (const std::string length : {"-1", "nan", "wide"}) {
    const Outcome outcome =
        run({"remesh", model, "--remove-handles", length, "-o", path("repaired.obj")});
    EXPECT_EQ(outcome.exitCode, 1) << length;
    EXPECT_TRUE(contains(outcome.errors, "USAGE")) << outcome.errors;
  }
}

TEST_F(Command, noHandleIsAnAnswer) {
  const std::string model = kData + "/prism.obj";
  EXPECT_TRUE(contains(run({"handles", model}).output, "no handles: its genus is 0\n"));
  for (const std::string name : {"none.json", "none.csv", "none.obj", "none.glb"}) {
    const Outcome outcome = run({"handles", model, "-o", path(name)});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  }
  EXPECT_EQ(Json::parse(contentOf(path("none.json")))["handles"], Json::array());
  EXPECT_EQ(linesOf(contentOf(path("none.csv"))).size(), 1u);
}

TEST_F(Command, basePointsAreAtLeastOne) {
  for (const std::string number : {"0", "-3", "many", "1.5"}) {
    const Outcome outcome = run({"handles", kData + "/prism.obj", "--base-points", number});
    EXPECT_EQ(outcome.exitCode, 1) << number;
    EXPECT_TRUE(contains(outcome.errors, "USAGE")) << outcome.errors;
  }
}

}  // namespace
}  // namespace girth::test
