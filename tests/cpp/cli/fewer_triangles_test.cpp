// --faces of commands that measure: on fewer triangles, with the numbers of the file.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

constexpr int kAround = 80, kAcross = 40;

/// A torus of 6,400 triangles: its tube has radius 1, its middle line radius 4. The vertices run
/// round the tube first.
std::string torus() {
  std::string text;
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kAcross; ++k) {
      const double u = 2 * M_PI * i / kAround, v = 2 * M_PI * k / kAcross;
      const double ring = 4 + std::cos(v);
      text += "v " + std::to_string(ring * std::cos(u)) + " " + std::to_string(ring * std::sin(u)) +
              " " + std::to_string(std::sin(v)) + "\n";
    }
  }
  const auto vertex = [](int i, int k) {
    return " " + std::to_string(i % kAround * kAcross + k % kAcross + 1);
  };
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kAcross; ++k) {
      text += "f" + vertex(i, k) + vertex(i + 1, k) + vertex(i + 1, k + 1) + "\n";
      text += "f" + vertex(i, k) + vertex(i + 1, k + 1) + vertex(i, k + 1) + "\n";
    }
  }
  return text;
}

class FewerTriangles : public Command {
 protected:
  Outcome measure(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{arguments[0], model_};
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    return run(all);
  }

  std::string model_ = write("torus.obj", torus());
};

TEST_F(FewerTriangles, aNoteSaysHowMany) {
  const Outcome fewer = measure({"handles", "--faces", "1000", "--json"});
  ASSERT_EQ(fewer.exitCode, 0) << fewer.errors;
  EXPECT_TRUE(contains(fewer.errors, "triangles in place of 6400")) << fewer.errors;
  const Json loops = Json::parse(fewer.output)["handles"];
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(loops[0]["length"].get<double>(), 2 * M_PI, 0.15);
  EXPECT_NEAR(loops[1]["length"].get<double>(), 2 * M_PI * 3, 0.5);

  const Outcome enough = measure({"handles", "--faces", "6400", "--json"});
  ASSERT_EQ(enough.exitCode, 0) << enough.errors;
  EXPECT_FALSE(contains(enough.errors, "in place of")) << enough.errors;
  EXPECT_FALSE(Json::parse(enough.output).contains("fewerFaces"));
}

TEST_F(FewerTriangles, outputsSayOnHowMany) {
  const std::vector<std::vector<std::string>> commands = {
      {"tips"},
      {"limbs"},
      {"necks"},
      {"handles"},
      {"parts"},
      {"segments"},
      {"profile", "0", "9"},
      {"bottleneck", "0", "9"},
  };
  for (std::vector<std::string> arguments : commands) {
    SCOPED_TRACE(arguments[0]);
    arguments.insert(arguments.end(), {"--faces", "1000", "--json"});
    const Outcome outcome = measure(arguments);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const Json faces = Json::parse(outcome.output)["fewerFaces"];
    ASSERT_TRUE(faces.is_number()) << outcome.output.substr(0, 200);
    EXPECT_TRUE(contains(outcome.errors, "on " + faces.dump() + " triangles")) << outcome.errors;
  }

  const Outcome girth = measure(
      {"igf", "--faces", "1000", "--persistence", "0.5", "--json", "-o", path("girth.json")});
  ASSERT_EQ(girth.exitCode, 0) << girth.errors;
  const std::string faces = Json::parse(girth.output)["fewerFaces"].dump();
  EXPECT_EQ(Json::parse(contentOf(path("girth.json")))["fields"][0]["method"],
            "exact on " + faces + " faces, persistence 0.5");
}

TEST_F(FewerTriangles, verticesAreThoseOfTheFile) {
  // From the outer side to the other end of the torus, along the middle of its top or bottom.
  const std::string opposite = std::to_string(kAround / 2 * kAcross);
  const Outcome profile = measure({"profile", "0", opposite, "--faces", "1000", "--json"});
  ASSERT_EQ(profile.exitCode, 0) << profile.errors;
  const Outcome exact = measure({"profile", "0", opposite, "--json"});
  ASSERT_EQ(exact.exitCode, 0) << exact.errors;
  const auto lengthOf = [](const Outcome& outcome) {
    return Json::parse(outcome.output)["stations"].back()["distance"].get<double>();
  };
  EXPECT_NEAR(lengthOf(profile), lengthOf(exact), 0.05 * lengthOf(exact));

  // Each vertex of the file has a row, and neighbours far apart in the file's order their own.
  const Outcome parts = measure({"parts", "--faces", "1000", "-o", path("parts.csv"), "-q"});
  ASSERT_EQ(parts.exitCode, 0) << parts.errors;
  const auto rows = linesOf(contentOf(path("parts.csv")));
  ASSERT_EQ(rows.size(), 1u + kAround * kAcross);
  for (std::size_t v = 0; v < rows.size() - 1; ++v) {
    EXPECT_EQ(rows[v + 1].substr(0, rows[v + 1].find(',')), std::to_string(v));
  }
}

TEST_F(FewerTriangles, facesAreNotThoseOfTheFile) {
  const Outcome point = measure({"bottleneck", "7:0.2,0.3,0.5", "12", "--faces", "1000"});
  EXPECT_EQ(point.exitCode, 1);
  EXPECT_TRUE(contains(point.errors, "name a vertex")) << point.errors;
  const Outcome table = measure({"segments", "--faces", "1000", "-o", path("segments.csv")});
  EXPECT_EQ(table.exitCode, 1);
  EXPECT_TRUE(contains(table.errors, ".json")) << table.errors;
  EXPECT_FALSE(fs::exists(path("segments.csv")));
}

TEST_F(FewerTriangles, whatTakesHoursIsSaidBefore) {
  using namespace std::chrono_literals;
  for (const std::string command : {"tips", "igf"}) {
    const Process child = start({command, model_, "--subdivide", "100000"});
    waitUntilInterruptible(child);
    for (int i = 0; i < 3000 && !contains(contentOf(path("stderr")), "--faces 10000"); ++i) {
      std::this_thread::sleep_for(10ms);
    }
    ASSERT_TRUE(interrupt(child));
    const Outcome outcome = wait(child);
    EXPECT_EQ(outcome.exitCode, 3) << command;
    EXPECT_TRUE(contains(outcome.errors, "the exact girth of 100000 triangles may take hours"))
        << outcome.errors;
    EXPECT_EQ(contains(outcome.errors, "--method refined"), command == "igf");
  }
}

}  // namespace
}  // namespace girth::test
