// girth segments: on a bottle, whose body and tube a waist divides.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

constexpr int kSides = 12;

/// A wide body up to the waist at z = 3, and a long thin tube beyond it: a surface of revolution,
/// both ends closed. The middles of its ends are the last two vertices.
std::string bottle() {
  const std::vector<std::pair<double, double>> rings{{0, 2},   {1, 2},   {2, 2},   {3, 0.5},
                                                     {4, 0.8}, {5, 0.8}, {6, 0.8}, {7, 0.8}};
  std::string text;
  for (const auto& [z, radius] : rings) {
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * M_PI * i / kSides;
      text += "v " + std::to_string(radius * std::cos(angle)) + " " +
              std::to_string(radius * std::sin(angle)) + " " + std::to_string(z) + "\n";
    }
  }
  text += "v 0 0 0\nv 0 0 7\n";
  const int count = static_cast<int>(rings.size());
  const auto corner = [](int ring, int i) {
    return std::to_string(ring * kSides + i % kSides + 1);
  };
  for (int i = 0; i < kSides; ++i) {
    for (int ring = 0; ring + 1 < count; ++ring) {
      text += "f " + corner(ring, i) + " " + corner(ring, i + 1) + " " + corner(ring + 1, i + 1) +
              " " + corner(ring + 1, i) + "\n";
    }
    text += "f " + corner(0, i + 1) + " " + corner(0, i) + " " +
            std::to_string(count * kSides + 1) + "\nf " + corner(count - 1, i) + " " +
            corner(count - 1, i + 1) + " " + std::to_string(count * kSides + 2) + "\n";
  }
  return text;
}

TEST_F(Command, segmentsOfABottle) {
  const std::string model = write("bottle.obj", bottle());
  const std::vector<std::string> arguments{"segments", model, "--min-prominence", "0.5",
                                           "--girth",  "7",   "--shape-diameter", "2.5"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const Outcome outcome = with({"--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json found = Json::parse(outcome.output);
  ASSERT_EQ(found["segments"].size(), 2u);
  EXPECT_TRUE(found["crossing"].empty());
  EXPECT_EQ(found["thresholds"]["girth"], 7);
  const Json &body = found["segments"][0], &tube = found["segments"][1];
  EXPECT_EQ(body["kind"], "body");
  EXPECT_EQ(tube["kind"], "tube");
  EXPECT_EQ(body["boundaries"], 1);
  for (const Json& segment : found["segments"]) {
    double sum = 0;
    for (const Json& share : segment["shares"]) sum += share.get<double>();
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  // The parts are those that are cut, with their numbers.
  const Json parts = Json::parse(
      run({"cut", model, "--necks", "--min-prominence", "0.5", "--json"}).output)["parts"];
  ASSERT_EQ(parts.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& [name, value] : parts[i].items()) EXPECT_EQ(found["segments"][i][name], value);
  }
  // Every face has one: what lies below the waist the body's.
  const std::size_t faces = 2 * kSides * 7 + 2 * kSides;
  ASSERT_EQ(found["faces"].size(), faces);
  std::size_t below = 0;
  for (const Json& label : found["faces"]) below += label == 0 ? 1 : 0;
  EXPECT_EQ(below, 2u * kSides * 3 + kSides);
  // Tips are those of girth tips, each on the side where it is.
  const Json tips = Json::parse(run({"tips", model, "--json"}).output)["tips"];
  ASSERT_FALSE(tips.empty());
  std::set<int> numbers;
  for (const Json& segment : found["segments"]) {
    for (const Json& tip : segment["tips"]) {
      const int number = tip["tip"];
      EXPECT_TRUE(numbers.insert(number).second);
      EXPECT_EQ(tip["apex"], tips[static_cast<std::size_t>(number)]["apex"]);
      EXPECT_EQ(tip["apex"]["position"][2].get<double>() > 3, segment["kind"] == "tube");
    }
  }
  EXPECT_EQ(numbers.size(), tips.size());

  ASSERT_EQ(with({"-o", path("s.csv")}).exitCode, 0);
  const std::vector<std::string> lines = linesOf(contentOf(path("s.csv")));
  ASSERT_EQ(lines.size(), faces + 1);
  EXPECT_EQ(lines[0], "face,segment,kind,tips");
  for (std::size_t face = 0; face < faces; ++face) {
    const bool isBody = found["faces"][face] == 0;
    std::string expected = std::to_string(face) + (isBody ? ",0,body," : ",1,tube,");
    std::string list;
    for (const Json& tip : (isBody ? body : tube)["tips"]) {
      list += (list.empty() ? "" : " ") + std::to_string(tip["tip"].get<int>());
    }
    EXPECT_EQ(lines[face + 1], expected + list);
  }
  ASSERT_EQ(with({"-o", path("s.glb")}).exitCode, 0);
  const std::string glb = contentOf(path("s.glb"));
  for (const char* part : {"\"segment_0\"", "\"segment_1\"", "\"COLOR_0\"", "\"kind\":\"tube\""}) {
    EXPECT_TRUE(contains(glb, part)) << part;
  }
  EXPECT_EQ(Json::parse(run({"info", path("s.glb"), "--json"}).output)["faces"], faces);
  const Outcome text = with({});
  EXPECT_TRUE(contains(text.output, "2 segments\n")) << text.output;
}

TEST_F(Command, segmentsWithoutNecksAndBadLengths) {
  const Outcome outcome =
      run({"segments", kData + "/prism.obj", "--min-prominence", "1000", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(Json::parse(outcome.output)["segments"].size(), 1u);
  for (const std::string option : {"--min-prominence", "--girth", "--shape-diameter"}) {
    for (const std::string length : {"-1", "nan", "wide"}) {
      EXPECT_EQ(run({"segments", kData + "/prism.obj", option, length}).exitCode, 1) << option;
    }
  }
  EXPECT_EQ(run({"segments", kData + "/prism.obj", "-o", path("s.ply")}).exitCode, 1);
}

}  // namespace
}  // namespace girth::test
