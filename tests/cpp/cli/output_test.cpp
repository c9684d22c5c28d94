// Files on disk before, after and instead of an output.
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

/// A long tube of many faces, enough work for seconds.
std::string longTube(int rings, int sides) {
  std::string text;
  for (int k = 0; k <= rings; ++k) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 6.283185307179586 * (i + 0.5 * (k % 2)) / sides;
      const double radius = 1 + 0.3 * std::sin(0.1 * k);
      text += "v " + std::to_string(radius * std::cos(angle)) + " " +
              std::to_string(radius * std::sin(angle)) + " " + std::to_string(0.1 * k) + "\n";
    }
  }
  const auto v = [&](int k, int i) { return std::to_string(k * sides + i % sides + 1); };
  for (int k = 0; k < rings; ++k) {
    for (int i = 0; i < sides; ++i) {
      const int o = k % 2;
      text += "f " + v(k, i) + " " + v(k, i + 1) + " " + v(k + 1, i + o) + "\n";
      text += "f " + v(k, i + 1 - o) + " " + v(k + 1, i + 1) + " " + v(k + 1, i) + "\n";
    }
  }
  std::string top, bottom;
  for (int i = 0; i < sides; ++i) {
    bottom += " " + v(0, sides - i);
    top += " " + v(rings, i);
  }
  return text + "f" + bottom + "\nf" + top + "\n";
}

class Interrupted : public Command {
 protected:
  Outcome stopped(const std::vector<std::string>& arguments) const;
};

/// Starts the command, and interrupts it when it has computed for a while.
Outcome Interrupted::stopped(const std::vector<std::string>& arguments) const {
  const Process child = start(arguments);
  waitUntilInterruptible(child);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(interrupt(child));
  return wait(child);
}

TEST_F(Interrupted, endsAtOnceAndLeavesTheOutputWhole) {
  const std::string model = write("tube.obj", longTube(1200, 40));
  write("tube.csv", "whole");
  const Process child = start({"igf", model, "-o", path("tube.csv")});
  waitUntilInterruptible(child);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  ASSERT_TRUE(interrupt(child));
  const Outcome outcome = wait(child);
  EXPECT_EQ(outcome.exitCode, 3) << outcome.errors << outcome.output;
  EXPECT_NE(outcome.errors.find("CANCELLED"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("tube.partial.csv"), std::string::npos) << outcome.errors;
  EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
  EXPECT_EQ(contentOf(path("tube.csv")), "whole");
  const std::string partial = contentOf(path("tube.partial.csv"));
  EXPECT_EQ(partial.rfind("# girth igf, stopped: ", 0), 0u);
  // It stopped in the midst of its work.
  EXPECT_LT(linesOf(partial).size(), std::size_t{1200 * 40});
}

TEST_F(Interrupted, whatAnotherRunHasLeftIsKeptUnderAnotherName) {
  const std::string model = write("tube.obj", longTube(70, 12));
  const std::string other = write("other.obj", longTube(5, 12));
  const std::string output = path("values.csv");
  ASSERT_EQ(stopped({"igf", model, "--threads", "1", "-o", output}).exitCode, 3);
  const std::string left = contentOf(path("values.partial.csv"));
  EXPECT_EQ(run({"igf", model, "-o", output}).exitCode, 1) << "its own is gone on from";

  const Outcome begun = run({"igf", other, "-o", output});
  EXPECT_EQ(begun.exitCode, 0) << begun.errors;
  for (const char* words : {"values.partial.csv", " of 852 vertices of ", "tube.obj",
                            "another model", "kept as", "values.partial-2.csv"}) {
    EXPECT_NE(begun.errors.find(words), std::string::npos) << words << ": " << begun.errors;
  }
  EXPECT_FALSE(fs::exists(path("values.partial.csv")));
  EXPECT_EQ(contentOf(path("values.partial-2.csv")), left);

  // A run with other options, a damaged file and one without the model's name are kept alike.
  const std::string untitled = left.substr(0, left.find(" vertices")) + " vertices" +
                               left.substr(left.find("; the same command"));
  for (const std::string& text : {left, std::string("nonsense"), std::string(), untitled}) {
    write("values.partial.csv", text);
    const Outcome again = run({"igf", other, "-o", output, "--method", "ms"});
    EXPECT_EQ(again.exitCode, 0) << again.errors;
    EXPECT_FALSE(fs::exists(path("values.partial.csv")));
  }
  EXPECT_EQ(contentOf(path("values.partial-4.csv")), "nonsense");
}

TEST_F(Interrupted, resumingGivesTheSameBits) {
  const std::string model = write("tube.obj", longTube(70, 12));
  ASSERT_EQ(run({"igf", model, "-o", path("whole.csv")}).exitCode, 0);
  for (const char* name : {"tube.csv", "tube.ply"}) {
    const std::string output = path(name);
    ASSERT_EQ(stopped({"igf", model, "--threads", "1", "-o", output}).exitCode, 3);
    ASSERT_TRUE(fs::exists(path("tube.partial.csv")));
    EXPECT_FALSE(fs::exists(output));
    // A file that is left is neither overwritten nor taken for that of another run.
    EXPECT_EQ(run({"igf", model, "-o", output}).exitCode, 1);
    const std::string other = write("other.obj", longTube(69, 12));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"igf", model, "-o", output, "--resume", "--method", "ms"},
          {"igf", model, "-o", output, "--resume", "--faces", "1000"},
          {"igf", other, "-o", output, "--resume"}}) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
      EXPECT_NE(outcome.errors.find("INVALID_OPTION"), std::string::npos) << outcome.errors;
      EXPECT_NE(outcome.errors.find("--force"), std::string::npos) << outcome.errors;
    }
    const std::string left = contentOf(path("tube.partial.csv"));
    write("tube.partial.csv", left + "7,x,loop\n");
    EXPECT_EQ(run({"igf", model, "-o", output, "--resume"}).exitCode, 2) << "a damaged line";
    write("tube.partial.csv", left);

    const Outcome resumed = run({"igf", model, "-o", output, "--resume"});
    EXPECT_EQ(resumed.exitCode, 0) << resumed.errors;
    EXPECT_NE(resumed.errors.find("going on from"), std::string::npos) << resumed.errors;
    EXPECT_FALSE(fs::exists(path("tube.partial.csv")));
  }
  EXPECT_EQ(contentOf(path("tube.csv")), contentOf(path("whole.csv")));
  ASSERT_EQ(run({"igf", model, "-o", path("whole.ply"), "--resume"}).exitCode, 0)
      << "nothing is left: it begins at the beginning";
  EXPECT_EQ(contentOf(path("tube.ply")), contentOf(path("whole.ply")));
}

TEST_F(Command, outputsKeepLinksAndModesAndAreNotTheModel) {
  const std::string prism = kData + "/prism.obj";
  const std::string kept = write("kept.csv", "old");
  fs::permissions(kept, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("kept.csv", path("link.csv"));
  ASSERT_EQ(run({"igf", prism, "-o", path("link.csv")}).exitCode, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.csv")));
  EXPECT_NE(contentOf(kept), "old");
  EXPECT_EQ(fs::status(kept).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  // A link to nothing yet makes what it names; one in a circle is refused.
  fs::create_symlink("new.csv", path("fresh.csv"));
  ASSERT_EQ(run({"igf", prism, "-o", path("fresh.csv")}).exitCode, 0);
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("new.csv"))));
  fs::create_symlink("circle.csv", path("circle.csv"));
  EXPECT_EQ(run({"igf", prism, "-o", path("circle.csv")}).exitCode, 2);

  fs::copy_file(prism, path("model.obj"));
  fs::create_symlink("model.obj", path("same.obj"));
  for (const char* name : {"model.obj", "same.obj"}) {
    const Outcome refused = run({"remesh", path("model.obj"), "--faces", "60", "-o", path(name)});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.errors.find("--force"), std::string::npos) << refused.errors;
    EXPECT_EQ(contentOf(path("model.obj")), contentOf(prism));
  }
  EXPECT_EQ(run({"remesh", path("model.obj"), "--faces", "60", "-o", path("same.obj"), "--force"})
                .exitCode,
            0);
  EXPECT_NE(contentOf(path("model.obj")), contentOf(prism));
  EXPECT_TRUE(fs::is_symlink(path("same.obj")));
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

TEST_F(Command, standardOutputTakesOneResult) {
  const std::string prism = kData + "/prism.obj";
  ASSERT_EQ(run({"igf", prism, "-o", path("a.csv")}).exitCode, 0);
  const Outcome piped = run({"igf", prism, "-o", "-", "--format", "csv"});
  EXPECT_EQ(piped.exitCode, 0) << piped.errors;
  EXPECT_EQ(piped.output, contentOf(path("a.csv")));
  ASSERT_EQ(run({"igf", prism, "-o", path("values"), "--format", "csv"}).exitCode, 0);
  EXPECT_EQ(contentOf(path("values")), contentOf(path("a.csv")));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"igf", prism, "-o", "-"},
        {"igf", prism, "-o", "-", "--format", "xyz"},
        {"igf", prism, "-o", "-", "--format", "csv", "--json"},
        {"igf", prism, "-o", "/dev/stdout", "--format", "csv", "--json"},
        {"igf", prism, "--format", "csv"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_EQ(outcome.output.find("vertex"), std::string::npos) << outcome.output;
  }
}

TEST_F(Command, aFigureHasLoopsAndTipsInIt) {
  const std::string model = kData + "/prism.obj", figure = path("figure.glb");
  ASSERT_EQ(run({"igf", model, "-o", figure, "--loops", "3,20", "--tips", "-q"}).exitCode, 0);
  const std::string content = contentOf(figure);
  EXPECT_TRUE(contains(content, "\"loop 3\"")) << "the prism's vertices keep their numbers";
  EXPECT_TRUE(contains(content, "\"loop 20\""));
  EXPECT_TRUE(contains(content, "\"crossedEdges\""));
  // It is still the same surface.
  const auto length = [&](const std::string& file) {
    return nlohmann::json::parse(run({"loop", file, "3", "--json"}).output)["length"].get<double>();
  };
  EXPECT_NEAR(length(figure) / length(model), 1, 1e-6);

  const Outcome missing = run({"igf", model, "-o", path("other.glb"), "--loops", "3,5000"});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_TRUE(contains(missing.errors, "VERTEX_OUT_OF_RANGE")) << missing.errors;
  EXPECT_TRUE(contains(missing.errors, "there is no vertex 5000")) << missing.errors;
  for (const char* option : {"--loops=3", "--tips"}) {
    const Outcome text = run({"igf", model, "-o", path("values.csv"), option});
    EXPECT_EQ(text.exitCode, 1) << option;
    EXPECT_TRUE(contains(text.errors, "only .glb holds loops and tips")) << text.errors;
  }
}

}  // namespace
}  // namespace girth::test
