// --persistence and --barcode: loops whose saddles do not last are passed over.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A square prism of sides 1, 20 long, with a spike on one end: a pyramid 0.2 wide and 0.5 high,
/// with a ring of vertices, 12 to 15, half-way up.
std::string spikedPrism() {
  std::string text;
  const auto ring = [&](double half, double z) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      text += "v " + std::to_string(x * half) + " " + std::to_string(y * half) + " " +
              std::to_string(z) + "\n";
    }
  };
  ring(0.5, 0);
  ring(0.5, 20);
  ring(0.1, 20);
  ring(0.05, 20.25);
  text += "v 0 0 20.5\nf 4 3 2 1\n";
  for (int r = 0; r < 3; ++r) {
    for (int i = 0; i < 4; ++i) {
      const int a = 4 * r + i + 1, b = 4 * r + (i + 1) % 4 + 1;
      text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(b + 4) +
              " " + std::to_string(a + 4) + "\n";
    }
  }
  for (int i = 0; i < 4; ++i) {
    text += "f " + std::to_string(13 + i) + " " + std::to_string(13 + (i + 1) % 4) + " 17\n";
  }
  return text;
}

/// Measures at a vertex half-way up the spike, which unfolds to a cone.
struct Spike {
  double slant{std::hypot(0.05, 0.05, 0.25)};
  /// The angle of all four faces at the apex.
  double angle{8 * std::atan(0.05 / std::hypot(0.05, 0.25))};
  /// Half the loop round the spike, and the distance of the apex, where the tip is filled.
  double birth{slant * std::sin(angle / 2)}, death{slant};
};

class Persistence : public Command {
 protected:
  std::vector<double> girthOf(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"igf", model_, "-o", path("values.json"), "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(contentOf(path("values.json")))["igf"];
  }

  std::string model_{write("spike.obj", spikedPrism())};
};

TEST_F(Persistence, passesOverASpike) {
  const Spike spike;
  const double lasting = spike.death - spike.birth;
  const auto girth = girthOf({});
  EXPECT_NEAR(girth[12], 2 * spike.birth, 1e-9);
  EXPECT_NEAR(girthOf({"--persistence", std::to_string(0.9 * lasting)})[12], girth[12], 1e-12);
  const auto passed = girthOf({"--persistence", std::to_string(1.1 * lasting)});
  EXPECT_GT(passed[12], 1);
  for (std::size_t v = 0; v < girth.size(); ++v) EXPECT_GE(passed[v], girth[v]);

  // Persistence with units and shares. The area: the prism, its end, the spike on the other.
  const double area = 4 * 20 + 2 - 0.04 + 4 * 0.1 * std::hypot(0.1, 0.5);
  const std::string percent = std::to_string(100 * 1.1 * lasting / std::sqrt(area)) + "%";
  EXPECT_EQ(girthOf({"--persistence", percent}), passed);
  const std::string length = std::to_string(1.1 * lasting) + "mm";
  EXPECT_EQ(girthOf({"--persistence", length, "--unit", "mm"}), passed);
  EXPECT_EQ(girthOf({"--persistence", "0"}), girth);
}

TEST_F(Persistence, standsInEveryAnswer) {
  const std::vector<std::string> wanted{"--persistence", "0.2 mm", "--unit", "mm"};
  const auto answer = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), wanted.begin(), wanted.end());
    const Outcome outcome = run(arguments);
    EXPECT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.errors;
    return outcome.output;
  };
  for (const std::vector<std::string>& command : {std::vector<std::string>{"igf", model_},
                                                  {"loop", model_, "12"},
                                                  {"tips", model_},
                                                  {"limbs", model_},
                                                  {"parts", model_},
                                                  {"parts", model_, "--min-tube", "0.1"}}) {
    EXPECT_TRUE(contains(answer(command), "persistence 0.2 mm")) << command[0];
    std::vector<std::string> asJson = command;
    asJson.emplace_back("--json");
    EXPECT_EQ(Json::parse(answer(asJson))["persistence"], 0.2) << command[0];
  }
  const Json loop = Json::parse(answer({"loop", model_, "12", "--json"}));
  EXPECT_EQ(loop["length"], girthOf({"--persistence", "0.2"})[12]);
  EXPECT_FALSE(Json::parse(run({"tips", model_, "--json"}).output).contains("persistence"));
  answer({"parts", model_, "-o", path("parts.ply")});
  EXPECT_TRUE(contains(contentOf(path("parts.ply")), "exact, persistence 0.2"));
  answer({"field", model_, "--field", "angle", "-o", path("angle.json")});
  const Json angle = Json::parse(contentOf(path("angle.json")));
  EXPECT_EQ(angle["fields"][0]["method"], "exact, persistence 0.2");
  EXPECT_EQ(angle["angle"][12], loop["angle"]);
}

TEST_F(Persistence, isAShareWhereModelsAreCompared) {
  const auto signature = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"signature", model_, "-o", path("s.csv")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(run(arguments).exitCode, 0);
    return contentOf(path("s.csv"));
  };
  EXPECT_EQ(signature({"--persistence", "0%"}), signature({}));
  EXPECT_NE(signature({"--persistence", "5%"}), signature({}));
  EXPECT_EQ(signature({"--persistence", "5%"}), signature({"--persistence", "5%", "--scale", "4"}))
      << "a power of two";
  const Json compared =
      Json::parse(run({"compare", model_, model_, "--persistence", "5%", "--json"}).output);
  EXPECT_LT(compared["descriptors"][0]["distances"][0][1], 1e-12);
  EXPECT_TRUE(compared["descriptors"][0]["typical"].is_null()) << "not measured";
  EXPECT_EQ(run({"signature", model_, "-o", path("s.csv"), "--persistence", "0.1"}).exitCode, 1);
}

TEST_F(Persistence, barcodesAreWritten) {
  const Spike spike;
  for (const char* name : {"bars.json", "bars.csv", "bars.npy"}) {
    const auto girth = girthOf({"--barcode", path(name), "--persistence", "0.2"});
    EXPECT_EQ(girth, girthOf({"--persistence", "0.2"})) << "read off the bars, the same bits";
  }
  const Json bars = Json::parse(contentOf(path("bars.json")));
  EXPECT_EQ(bars["maxPersistence"], 0.2);
  ASSERT_EQ(bars["bars"].size(), 17u);
  EXPECT_NEAR(bars["bars"][12][0][0], spike.birth, 1e-9);
  EXPECT_NEAR(bars["bars"][12][0][1], spike.death, 1e-9);
  std::size_t count = 0;
  for (const Json& one : bars["bars"]) count += one.size();
  EXPECT_EQ(linesOf(contentOf(path("bars.csv"))).size(), count + 1);
  const std::string npy = contentOf(path("bars.npy"));
  EXPECT_TRUE(contains(npy, "'shape': (" + std::to_string(count) + ", 3)"));

  // All of them, beside the girth itself.
  EXPECT_EQ(girthOf({"--barcode", path("all.json")}), girthOf({}));
  const Json all = Json::parse(contentOf(path("all.json")));
  EXPECT_TRUE(all["maxPersistence"].is_null());
  for (std::size_t v = 0; v < 17; ++v) {
    EXPECT_EQ(all["restKind"][v], "antipodal");
    EXPECT_GE(all["bars"][v].size(), bars["bars"][v].size());
  }
}

TEST_F(Persistence, ofAStoppedRunBelongsToIt) {
  write("values.partial.csv", "# girth igf, stopped: 1 of 17\n# girth 0\n");
  const Outcome outcome =
      run({"igf", model_, "-o", path("values.csv"), "--resume", "--persistence", "1%"});
  EXPECT_NE(outcome.exitCode, 0);
  EXPECT_TRUE(contains(outcome.errors, "values.partial.csv")) << outcome.errors;
}

TEST_F(Persistence, badInputIsOneLine) {
  const auto igf = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"igf", model_});
    return options;
  };
  struct Case {
    std::vector<std::string> arguments;
    const char* words;
  };
  for (const Case& c :
       {Case{igf({"--persistence", "-1"}), "is not a length of at least 0"},
        Case{igf({"--persistence=-2%"}), "is not a share of at least 0%"},
        Case{igf({"--persistence", "nan"}), "is not a length"},
        Case{igf({"--persistence", "inf"}), "is not a length"},
        Case{igf({"--persistence", ""}), "is not a length"},
        Case{igf({"--persistence", "2 mm"}), "the model's unit is not known"},
        Case{igf({"--persistence", "2 parsec"}), "unknown unit"},
        Case{igf({"--persistence", "1", "--method", "ms"}), "only the exact method"},
        Case{igf({"--persistence", "1", "--method", "naive"}), "only the exact method"},
        Case{igf({"--barcode", path("b.json"), "--method", "ms"}), "only the exact method"},
        Case{igf({"--barcode", path("b.ply")}), "no known ending"},
        Case{igf({"--barcode", "-"}), "--barcode writes a file"},
        Case{igf({"--barcode", path("b.json"), "--faces", "10"}), "cannot be given together"},
        Case{igf({"--barcode", model_ + "/b.json"}), "its folder does not exist"},
        Case{igf({model_, "--barcode", path("b.json")}), "several models"},
        Case{igf({"--barcode", path("b.json"), "-o", path("b.json")}), "the same file"},
        Case{{"compare", model_, model_, "--persistence", "1"}, "is no percentage"}}) {
    const Outcome outcome = run(c.arguments);
    EXPECT_TRUE(outcome.exitCode == 1 || outcome.exitCode == 2) << outcome.errors;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, c.words)) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
  // Longer than the surface: no saddle of a sphere lasts so long.
  for (const char* length : {"1000%", "1e300"}) {
    const Json summary =
        Json::parse(run({"igf", model_, "--persistence", length, "--json"}).output);
    EXPECT_EQ(summary["antipodal"], 17) << length;
  }
}

}  // namespace
}  // namespace girth::test
