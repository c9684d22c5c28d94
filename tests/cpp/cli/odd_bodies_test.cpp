// Thickness, tips, parts and print checks of what is no proper body, and with lengths that are
// none: a result or a stated reason, and the exit code that is documented.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

using Corner = std::array<double, 3>;

/// Boxes as OBJ.
class Boxes {
 public:
  /// The box between two corners; its faces look outwards, or inwards.
  Boxes& add(const Corner& low, const Corner& high, bool inwards = false) {
    for (int i = 0; i < 8; ++i) {
      vertices_ += "v";
      for (std::size_t axis = 0; axis < 3; ++axis) {
        vertices_ += " " + std::to_string((i >> (2 - axis) & 1) != 0 ? high[axis] : low[axis]);
      }
      vertices_ += "\n";
    }
    for (const auto& [a, b, c, d] : {std::array{0, 1, 3, 2},
                                     {4, 6, 7, 5},
                                     {0, 4, 5, 1},
                                     {2, 3, 7, 6},
                                     {0, 2, 6, 4},
                                     {1, 5, 7, 3}}) {
      face(a, inwards ? c : b, inwards ? b : c);
      face(a, inwards ? d : c, inwards ? c : d);
    }
    count_ += 8;
    return *this;
  }
  std::string text() const { return vertices_ + faces_; }

 private:
  void face(int a, int b, int c) {
    faces_ += "f";
    for (const int v : {a, b, c}) faces_ += " " + std::to_string(count_ + v + 1);
    faces_ += "\n";
  }

  std::string vertices_, faces_;
  int count_{0};
};

/// A square of two sheets, one over the other, joined at the rim.
std::string sheets() {
  std::string text;
  const auto corner = [](int x, int y, bool lower) {
    const bool rim = x == 0 || y == 0 || x == 3 || y == 3;
    return 1 + 4 * y + x + (lower && !rim ? 16 : 0);
  };
  for (int copy = 0; copy < 2; ++copy) {
    for (int i = 0; i < 16; ++i) {
      text += "v " + std::to_string(i % 4) + " " + std::to_string(i / 4) + " 0\n";
    }
  }
  for (const bool lower : {false, true}) {
    for (int i = 0; i < 9; ++i) {
      const int x = i % 3, y = i / 3;
      const int a = corner(x, y, lower), b = corner(x + 1, y, lower);
      const int c = corner(x + 1, y + 1, lower), d = corner(x, y + 1, lower);
      const auto face = [&](int u, int v, int w) {
        text += "f " + std::to_string(u) + " " + std::to_string(lower ? w : v) + " " +
                std::to_string(lower ? v : w) + "\n";
      };
      face(a, b, c);
      face(a, c, d);
    }
  }
  return text;
}

TEST_F(Command, whatIsNoProperBodyGetsAnAnswerOrAReason) {
  struct Case {
    const char* name;
    std::string content;
    bool hasDiameter;  // somewhere, to be checked
    const char* note;  // on standard error
  };
  const std::string sheet = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  const Corner zero{0, 0, 0};
  for (const Case& c :
       {Case{"open", sheet, false, "have no shape diameter"},
        Case{"inside_out", Boxes().add(zero, {2, 2, 2}, true).text(), false, "inside out"},
        Case{"one_in_another", Boxes().add(zero, {4, 4, 4}).add({1, 1, 1}, {2, 2, 2}).text(), true,
             ""},
        Case{"hollow", Boxes().add(zero, {4, 4, 4}).add({1, 1, 1}, {3, 3, 3}, true).text(), true,
             ""},
        Case{"crossing", Boxes().add(zero, {4, 1, 1}).add({1.5, -1, 0.2}, {2, 2, 0.8}).text(), true,
             ""},
        Case{"no_volume", sheets(), false, "have no shape diameter"},
        Case{"box_without_height", Boxes().add(zero, {4, 4, 0}).text(), false,
             "have no shape diameter"}}) {
    const std::string file = write(std::string(c.name) + ".obj", c.content);
    const Outcome field = run({"field", file, "--field", "sdf", "--json"});
    EXPECT_EQ(field.exitCode, 0) << c.name << field.errors;
    const Json values = Json::parse(field.output);
    EXPECT_EQ(values["withValue"] > 0, c.hasDiameter) << c.name;
    EXPECT_EQ(values["max"].is_null(), !c.hasDiameter) << c.name;
    EXPECT_NE(field.errors.find(c.note), std::string::npos) << c.name << field.errors;

    const Outcome tips = run({"tips", file, "--json"});
    EXPECT_EQ(tips.exitCode, 0) << c.name << tips.errors;
    EXPECT_TRUE(Json::parse(tips.output)["tips"].is_array()) << c.name;

    const Outcome parts = run({"parts", file});
    EXPECT_EQ(parts.exitCode, 0) << c.name << parts.errors;
    EXPECT_EQ(parts.output.find("nan"), std::string::npos) << parts.output;
    EXPECT_EQ(parts.output.find("unknown") != std::string::npos, !c.hasDiameter) << parts.output;

    // The girth can be checked of any surface.
    const Outcome tube = run({"parts", file, "--min-tube", "0.01"});
    EXPECT_EQ(tube.exitCode, 0) << c.name << tube.errors;
    EXPECT_EQ(run({"parts", file, "--min-tube", "100"}).exitCode, 4) << c.name;
    const Outcome wall = run({"parts", file, "--min-wall", "0.01"});
    EXPECT_EQ(wall.exitCode, c.hasDiameter ? 0 : 2) << c.name << wall.errors;
    if (!c.hasDiameter) {
      EXPECT_EQ(wall.output, "") << c.name;
      EXPECT_NE(wall.errors.find("NO_THICKNESS"), std::string::npos) << c.name << wall.errors;
    }
    EXPECT_EQ(run({"parts", file, "--min-wall", "100"}).exitCode, c.hasDiameter ? 4 : 2) << c.name;
  }
}

TEST_F(Command, wallsOfASurfaceThatIsInsideOutDoNotPass) {
  // Across the gap between its two boxes it has a thickness, which is none of the body's.
  const std::string file =
      write("inside_out.obj",
            Boxes().add({0, 0, 0}, {2, 2, 2}, true).add({2.5, -3, -3}, {4.5, 5, 5}, true).text());
  EXPECT_GT(Json::parse(run({"field", file, "--field", "sdf", "--json"}).output)["withValue"], 0);
  const Outcome wall = run({"parts", file, "--min-wall", "0.1"});
  EXPECT_EQ(wall.exitCode, 2);
  EXPECT_EQ(wall.output, "");
  EXPECT_NE(wall.errors.find("NO_THICKNESS: the surface is inside out"), std::string::npos)
      << wall.errors;
}

TEST_F(Command, lengthsThatAreNoneAreRefusedBeforeTheWork) {
  const std::string prism = kData + "/prism.obj";
  for (const char* option : {"--girth", "--shape-diameter", "--min-tube", "--min-wall"}) {
    for (const char* value :
         {"nan", "-1", "-0.5mm", "inf", "", "3 parsecs", "mm", "1e400", "1,5,0"}) {
      const Outcome outcome = run({"parts", prism, "--unit", "mm", option, value});
      EXPECT_EQ(outcome.exitCode, 1) << option << " '" << value << "' " << outcome.errors;
      EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
      EXPECT_EQ(outcome.output, "") << option << " " << value;
    }
    EXPECT_EQ(run({"parts", prism, option}).exitCode, 1) << option << " without a length";
  }
  for (const char* value : {"nan", "-1", "much"}) {
    EXPECT_EQ(run({"parts", prism, "--smooth-labels", value}).exitCode, 1) << value;
  }
  for (const char* value : {"nan", "0", "-30", "180", "wide"}) {
    EXPECT_EQ(run({"field", prism, "--field", "sdf", "--cone", value}).exitCode, 1) << value;
  }
  for (const char* value : {"0", "-3", "10001", "many"}) {
    EXPECT_EQ(run({"field", prism, "--field", "sdf", "--rays", value}).exitCode, 1) << value;
  }
}

}  // namespace
}  // namespace girth::test
