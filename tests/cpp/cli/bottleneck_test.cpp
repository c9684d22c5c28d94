// girth bottleneck and girth profile, on an hourglass of known girth.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, theBottleneckOfAnHourglass) {
  const std::string model = write("hourglass.obj", hourglass());
  const Outcome outcome =
      run({"bottleneck", model, "0", "15", "--unit", "cm", "-o", path("b.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("b.json")), outcome.output);
  const Json found = Json::parse(outcome.output);
  EXPECT_EQ(found["unit"], "centimetre");
  EXPECT_EQ(found["kind"], "neck");
  EXPECT_NEAR(found["girth"].get<double>(), 6, 1e-5);  // the file has six decimals
  EXPECT_NEAR(found["centre"][2].get<double>(), 3, 1e-9);
  EXPECT_EQ(found["points"].size(), 7u);
  EXPECT_EQ(found["sides"].size(), 2u);
  EXPECT_EQ(found["way"].front()["vertices"], Json::array({0}));
  EXPECT_EQ(found["way"].back()["vertices"], Json::array({15}));
  const Outcome text = run({"bottleneck", model, "0", "15", "--unit", "cm"});
  EXPECT_TRUE(contains(text.output, "a neck between the points\n")) << text.output;
  EXPECT_TRUE(contains(text.output, " cm\n"));

  // Points of faces; quadrilaterals count as two triangles.
  const Json inFaces = Json::parse(
      run({"bottleneck", model, "0:0.9,0.05,0.05", "23:0.05,0.9,0.05", "--json"}).output);
  EXPECT_NEAR(inFaces["girth"].get<double>(), 6, 1e-5);
  // A point on the neck itself has no neck before it.
  const Outcome end = run({"bottleneck", model, "0", "6"});
  EXPECT_TRUE(contains(end.output, "no neck between the points")) << end.output;

  ASSERT_EQ(run({"bottleneck", model, "0", "15", "-o", path("b.obj")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("b.obj")), "o bottleneck\n"));
  EXPECT_TRUE(contains(contentOf(path("b.obj")), "o way\n"));
  ASSERT_EQ(run({"bottleneck", model, "0", "15", "-o", path("b.glb")}).exitCode, 0);
  EXPECT_TRUE(contains(contentOf(path("b.glb")), "\"bottleneck\""));
}

TEST_F(Command, theProfileOfAnHourglass) {
  const std::string model = write("hourglass.obj", hourglass());
  // Along an edge to the waist, and along the next one up again.
  ASSERT_EQ(
      run({"profile", model, "0", "6", "12", "--samples", "21", "-o", path("p.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("p.csv")));
  ASSERT_EQ(rows.size(), 22u);  // its vertices are samples
  EXPECT_EQ(rows[0], "distance,girth,x,y,z,kind,unit");
  const Outcome outcome = run({"profile", model, "0", "6", "12", "--samples", "21", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json stations = Json::parse(outcome.output)["stations"];
  ASSERT_EQ(stations.size(), 21u);
  EXPECT_NEAR(stations[10]["girth"].get<double>(), 6, 1e-5);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    // Girth and distance are the same on both sides of the waist.
    EXPECT_NEAR(stations[i]["girth"].get<double>(), stations[20 - i]["girth"].get<double>(), 1e-4);
    EXPECT_GE(stations[i]["girth"].get<double>(), 6 - 1e-5);
  }
  const Outcome text = run({"profile", model, "0", "12", "--unit", "mm"});
  EXPECT_TRUE(contains(text.output, "least     6 mm at distance ")) << text.output;
  EXPECT_FALSE(contains(text.output, "without --even"));
  EXPECT_TRUE(contains(run({"profile", model, "0", "12", "--even"}).output,
                       "between these places it may be less"));
}

TEST_F(Command, pointsThatAreNoneAreNamed) {
  const std::string model = write("hourglass.obj", hourglass());
  const auto refused = [&](const std::vector<std::string>& arguments, int code,
                           const std::string& words) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << outcome.errors;
  };
  for (const std::string command : {"bottleneck", "profile"}) {
    refused({command, model, "0", "99"}, 1, "there is no vertex 99");
    refused({command, model, "0", "99:1,0,0"}, 1, "there is no face 99");
    refused({command, model, "0", "one"}, 1, "\"one\" is no point");
    refused({command, model, "0", "1:0.5,0.5"}, 1, "not three numbers");
    refused({command, model, "0", "1:0.5,0.5,0.5"}, 1, "INVALID_POINT");
    refused({command, model, "0", "1:nan,0,1"}, 1, "INVALID_POINT");
    // Two hourglasses.
    const std::string two = write("two.obj", hourglass() + hourglass(20, kHourglassVertices));
    refused({command, two, "0", "18"}, 1, "lie in different components");
  }
  refused({"bottleneck", model, "0"}, 1, "TO");
  refused({"profile", model, "0"}, 1, "a path needs two points");
  refused({"profile", model, "0", "12", "--samples", "1"}, 1, "1 samples are not a profile");
  refused({"profile", model, "0", "12", "--samples", "0", "--even"}, 1,
          "neither samples nor crossings");
  refused({"profile", model, "0", "12", "--samples", "-3"}, 1, "");
}

}  // namespace
}  // namespace girth::test
