// girth limbs, on a pencil of known girth.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

constexpr int kCorners = 8, kLength = 8;
/// Round the middle: the perimeter of a regular octagon with corners 1 from its centre.
const double kGirth = 2 * kCorners * std::sin(M_PI / kCorners);

/// An octagonal pencil as OBJ: from a flat end at 0 to 8, and then to a point at 11. The point is
/// vertex 0 of the file.
std::string pencil() {
  std::string text = "v 0 0 11\n";
  for (int ring = 0; ring <= kLength; ++ring) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * M_PI * i / kCorners;
      text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " " +
              std::to_string(ring) + "\n";
    }
  }
  text += "v 0 0 0\n";
  const auto at = [](int ring, int i) { return 2 + ring * kCorners + i % kCorners; };
  const auto face = [&](int a, int b, int c) {
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  for (int i = 0; i < kCorners; ++i) {
    face(1, at(kLength, i), at(kLength, i + 1));
    face(2 + (kLength + 1) * kCorners, at(0, i + 1), at(0, i));
    for (int ring = 0; ring < kLength; ++ring) {
      face(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      face(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
  }
  return text;
}

TEST_F(Command, limbsOfAPencil) {
  const std::string model = write("pencil.obj", pencil());
  const Outcome outcome = run({"limbs", model, "--unit", "cm", "-o", path("limbs.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("limbs.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  EXPECT_EQ(all["file"], model);
  EXPECT_TRUE(all["tipsWithoutLimb"].is_array());
  ASSERT_EQ(all["limbs"].size(), 1u);
  const Json& limb = all["limbs"][0];
  EXPECT_EQ(limb["end"], "whole");
  EXPECT_TRUE(limb["base"].is_null());
  // The point, or the middle of the flat end: both tips end the same limb.
  const int apex = limb["apex"]["vertices"][0];
  EXPECT_TRUE(apex == 0 || apex == 1 + (kLength + 1) * kCorners) << apex;
  EXPECT_EQ(limb["tips"].size(), 2u);
  EXPECT_EQ(limb["vertices"].size(), 2u + (kLength + 1) * kCorners);
  EXPECT_GT(limb["length"].get<double>(), 11);
  EXPECT_NEAR(limb["median"].get<double>(), kGirth, 0.01);
  EXPECT_NEAR(limb["middle"].get<double>(), kGirth, 1e-5);
  ASSERT_EQ(limb["profile"].size(), 64u);
  for (const Json& station : limb["profile"]) {
    EXPECT_GT(station["ring"].get<double>() + 1e-9, 0);
    EXPECT_EQ(station["least"].is_null(), station["place"].is_null());
    const double distance = station["distance"];
    if (distance < 5 || distance > 7) continue;
    EXPECT_NEAR(station["least"].get<double>(), kGirth, 1e-5);
  }

  EXPECT_EQ(run({"limbs", model, "--unit", "cm", "-o", path("limbs.csv")}).exitCode, 0);
  const std::vector<std::string> rows = linesOf(contentOf(path("limbs.csv")));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], "limb,length,narrowest,narrowestDistance,median,middle,base,end,apex,unit");
  EXPECT_NE(rows[1].find(",,whole,"), std::string::npos) << rows[1];

  EXPECT_EQ(run({"limbs", model, "--profiles", "--stations", "5", "-o", path("p.csv")}).exitCode,
            0);
  const std::vector<std::string> stations = linesOf(contentOf(path("p.csv")));
  ASSERT_EQ(stations.size(), 6u);
  EXPECT_EQ(stations[0], "limb,distance,ring,median,least,unit");
  EXPECT_EQ(stations[1].rfind("0,", 0), 0u);

  const Outcome text = run({"limbs", model, "--unit", "cm"});
  EXPECT_NE(text.output.find("1 limb"), std::string::npos) << text.output;
  EXPECT_NE(text.output.find("whole"), std::string::npos);
}

TEST_F(Command, profileAlongTheAxisOfAPencil) {
  const std::string model = write("pencil.obj", pencil());
  const Outcome outcome = run({"profile", model, "--limb", "0", "--samples", "48", "--unit", "cm",
                               "-o", path("axis.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("axis.json")), outcome.output);
  const Json axis = Json::parse(outcome.output);
  EXPECT_EQ(axis["unit"], "centimetre");
  std::size_t round = 0;
  double before = -1;
  for (const Json& loop : axis["loops"]) {
    EXPECT_GT(loop["distance"].get<double>(), before);
    before = loop["distance"];
    EXPECT_EQ(loop["points"].front(), loop["points"].back());
    const double z = loop["centre"][2];
    if (z < 2.5 || z > 6) continue;
    ++round;
    EXPECT_NEAR(loop["girth"].get<double>(), kGirth, 1e-5);
    EXPECT_NEAR(loop["centre"][0].get<double>(), 0, 1e-5);
    EXPECT_NEAR(loop["centre"][1].get<double>(), 0, 1e-5);
  }
  EXPECT_GE(round, 8u);
  EXPECT_EQ(axis["length"].get<double>(), before);

  EXPECT_EQ(run({"profile", model, "--limb", "0", "--samples", "48", "-o", path("a.csv")}).exitCode,
            0);
  const std::vector<std::string> rows = linesOf(contentOf(path("a.csv")));
  EXPECT_EQ(rows[0], "distance,along,girth,area,x,y,z,unit");
  EXPECT_EQ(rows.size(), axis["loops"].size() + 1);
  for (const std::string ending : {"obj", "glb"}) {
    const std::string file = path("loops." + ending);
    EXPECT_EQ(run({"profile", model, "--limb", "0", "-o", file}).exitCode, 0);
    EXPECT_FALSE(contentOf(file).empty());
  }
  EXPECT_TRUE(contains(contentOf(path("loops.obj")), "o axis\n"));
  EXPECT_TRUE(contains(run({"profile", model, "--limb", "0"}).output, "loops along an axis"));
  // The loops are curves to cut along.
  const Outcome few =
      run({"profile", model, "--limb", "0", "--samples", "4", "-o", path("few.json")});
  ASSERT_EQ(few.exitCode, 0) << few.errors;
  EXPECT_EQ(run({"cut", model, "--along", path("few.json")}).exitCode, 0);

  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"profile", model, "--limb", "2"},
        {"profile", model, "--limb=-1"},
        {"profile", model, "0", "5", "--limb", "0"},
        {"profile", model, "--limb", "0", "--even"},
        {"profile", model, "--limb", "0", "--samples", "0"},
        {"profile", model, "--limb", "0", "--samples", "10001"},
        {"profile", model, "0", "5", "-o", path("path.obj")}}) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.exitCode, 1) << arguments.back();
    EXPECT_EQ(linesOf(refused.errors).size(), 1u) << refused.errors;
  }
}

TEST_F(Command, limbsOfWhatHasNone) {
  const Outcome outcome = run({"limbs", kData + "/prism.obj", "--json"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_TRUE(Json::parse(outcome.output)["limbs"].is_array());
}

TEST_F(Command, limbsAreAskedForProperly) {
  const std::string model = write("pencil.obj", pencil());
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"limbs", model, "-o", path("limbs.obj")},
        {"limbs", model, "--stations", "0"},
        {"limbs", model, "--profiles"},
        {"limbs", model, "--profiles", "-o", path("limbs.json")}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << arguments.back();
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
  }
}

}  // namespace
}  // namespace girth::test
