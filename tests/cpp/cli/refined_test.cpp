// --method refined: loops in bands, how sure each value is, and the audit.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A torus whose tube swells and shrinks, of 3,000 triangles times the square of a number.
std::string bumpyTorus(int times = 1) {
  const int around = 60 * times, across = 25 * times;
  std::string text;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * (k + 0.5 * (i % 2)) / across;
      const double tube = 1 + 0.3 * std::cos(3 * u), ring = 4 + tube * std::cos(v);
      text += "v " + std::to_string(ring * std::cos(u)) + " " + std::to_string(ring * std::sin(u)) +
              " " + std::to_string(tube * std::sin(v)) + "\n";
    }
  }
  const auto vertex = [&](int i, int k) {
    return " " + std::to_string(i % around * across + (k + across) % across + 1);
  };
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      // Rows are shifted by half a triangle.
      const int shift = i % 2;
      text += "f" + vertex(i, k) + vertex(i + 1, k + shift) + vertex(i, k + 1) + "\n";
      text += "f" + vertex(i, k) + vertex(i + 1, k + shift - 1) + vertex(i + 1, k + shift) + "\n";
    }
  }
  return text;
}

class Refined : public Command {
 protected:
  std::string model_ = write("torus.obj", bumpyTorus());
};

TEST_F(Refined, valuesWithStatesAndAnAudit) {
  const Outcome outcome = run({"igf", model_, "--method", "refined", "--audit", "40", "-o",
                               path("refined.csv"), "--json", "--threads", "2"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json summary = Json::parse(outcome.output);
  EXPECT_EQ(summary["method"], "refined");
  EXPECT_EQ(summary["complete"], true);
  EXPECT_LE(summary["coarseFaces"], 750);
  EXPECT_EQ(summary["audit"]["vertices"], 40);
  EXPECT_LE(summary["audit"]["atLeast"], summary["audit"]["equal"].get<double>() / 40);
  EXPECT_GE(summary["audit"]["atMost"], summary["audit"]["equal"].get<double>() / 40);

  const auto lines = linesOf(contentOf(path("refined.csv")));
  EXPECT_EQ(lines[0], "vertex,igf,kind,state");
  ASSERT_EQ(lines.size(), 1501u);
  std::map<std::string, int> states;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    ++states[lines[i].substr(lines[i].rfind(',') + 1)];
  }
  for (const std::string state : {"proved", "consistent", "suspect"}) {
    EXPECT_EQ(summary[state], states[state]) << state;
  }
  EXPECT_GE(states["proved"], 40);
  EXPECT_EQ(states["proved"] + states["consistent"] + states["suspect"], 1500);

  // Nearly all are the exact method's, and a proved one always.
  ASSERT_EQ(run({"igf", model_, "-o", path("exact.csv"), "-q"}).exitCode, 0);
  const auto exact = linesOf(contentOf(path("exact.csv")));
  int equal = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto numberOf = [](const std::string& line) {
      return std::stod(line.substr(line.find(',') + 1));
    };
    equal += std::fabs(numberOf(lines[i]) / numberOf(exact[i]) - 1) < 1e-9 ? 1 : 0;
    if (contains(lines[i], "proved")) {
      EXPECT_EQ(lines[i], exact[i] + ",proved");
    }
  }
  EXPECT_GE(equal, 1485);
}

TEST_F(Refined, theSameBitsAsOtherFiles) {
  const std::vector<std::string> start{"igf", model_, "--method", "refined", "--audit", "0", "-q"};
  const auto written = [&](const std::string& name) {
    std::vector<std::string> arguments = start;
    arguments.insert(arguments.end(), {"-o", path(name)});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << name << outcome.errors;
    return contentOf(path(name));
  };
  const Json json = Json::parse(written("values.json"));
  EXPECT_EQ(json["igf"].size(), 1500u);
  EXPECT_EQ(json["state"].size(), 1500u);
  EXPECT_EQ(json["fields"][0]["method"], "refined");
  EXPECT_TRUE(contains(written("values.ply"), "property double state"));
  EXPECT_TRUE(contains(written("values.glb"), "_STATE"));
  EXPECT_EQ(written("values.npy").size(), 128 + 1500 * sizeof(double)) << "the girth alone";
}

TEST_F(Refined, whatIsStoppedLeavesNothing) {
  // Minutes of work.
  const std::string fine = write("fine.obj", bumpyTorus(4));
  const Process child =
      start({"igf", fine, "--method", "refined", "--audit", "1000000", "-o", path("v.csv")});
  waitUntilInterruptible(child);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_TRUE(terminate(child));
  const Outcome outcome = wait(child);
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_TRUE(contains(outcome.errors, "keeps nothing")) << outcome.errors;
  EXPECT_FALSE(contains(outcome.errors, "is kept")) << outcome.errors;
  EXPECT_FALSE(fs::exists(path("v.csv")));
  EXPECT_FALSE(fs::exists(path("v.csv.partial.csv")));
}

TEST_F(Refined, whatItDoesNotGoWith) {
  const auto refusal = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"igf", model_, "--method", "refined"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output;
    return outcome.errors;
  };
  EXPECT_TRUE(contains(refusal({"--faces", "1000"}), "leave one of them out"));
  EXPECT_TRUE(contains(refusal({"--resume", "-o", path("v.csv")}), "leave --resume out"));
  EXPECT_TRUE(contains(refusal({"--persistence", "1%"}), "only the exact method"));
  EXPECT_TRUE(contains(refusal({"--audit", "-1"}), "--audit"));
}

}  // namespace
}  // namespace girth::test
