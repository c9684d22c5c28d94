// Options that all commands that read models have in common: the options on how a model is
// prepared, and how many models they take.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

/// The words of a command, and what its help says.
using Helps = std::map<std::string, std::string>;

class ModelOptions : public Command {
 protected:
  /// The helps of all commands whose usage has a model or a folder of models.
  Helps readingCommands() const {
    Helps helps;
    for (const std::string& name : namesIn(run({"help"}).output)) {
      if (name != "study") helps[name] = run({"help", name}).output;
    }
    for (const std::string& name : namesIn(run({"help", "study"}).output)) {
      helps["study " + name] = run({"help", "study", name}).output;
    }
    Helps reading;
    for (const auto& [name, help] : helps) {
      if (contains(usageIn(help), " MODEL") || contains(usageIn(help), " DIR")) {
        reading[name] = help;
      }
    }
    return reading;
  }

  static std::string usageIn(const std::string& help) {
    const std::size_t at = help.find("Usage: ");
    return help.substr(at, help.find('\n', at) - at);
  }

 private:
  static std::vector<std::string> namesIn(const std::string& help) {
    std::vector<std::string> names;
    bool isList = false;
    for (const std::string& line : linesOf(help)) {
      if (line.empty()) isList = false;
      if (isList && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
      if (line == "Commands:") isList = true;
    }
    return names;
  }
};

TEST_F(ModelOptions, areThoseOfEveryCommandThatReadsAModel) {
  const Helps commands = readingCommands();
  EXPECT_EQ(commands.size(), 23u);
  for (const auto& [name, help] : commands) {
    for (const char* option :
         {"  --weld LENGTH ", "  --close-holes ", "  --component N ", "  --min-component SHARE ",
          "  --unit UNIT ", "  --in UNIT ", "  --scale N ", "  --height LENGTH ", "  --up AXIS ",
          "  --entry NAME "}) {
      EXPECT_TRUE(contains(help, option)) << name << option;
    }
  }
}

TEST_F(ModelOptions, reachTheModelInEveryCommand) {
  const std::string prism = kData + "/prism.obj";
  fs::create_directories(path("shapes/a"));
  fs::copy_file(prism, path("shapes/a/prism.obj"));
  const std::string pairs = write("pairs.csv", "0,1\n");
  const std::map<std::string, std::vector<std::string>> arguments{
      {"info", {"info", prism}},
      {"igf", {"igf", prism}},
      {"loop", {"loop", prism, "0"}},
      {"remesh", {"remesh", prism, "-o", path("r.obj")}},
      {"field", {"field", prism, "--field", "sdf", "-o", path("f.csv")}},
      {"tips", {"tips", prism}},
      {"limbs", {"limbs", prism}},
      {"parts", {"parts", prism}},
      {"necks", {"necks", prism}},
      {"handles", {"handles", prism}},
      {"section", {"section", prism}},
      {"tube", {"tube", prism}},
      {"tighten", {"tighten", prism, "--along", "0,1"}},
      {"distance", {"distance", prism, "--between", pairs}},
      {"segments", {"segments", prism}},
      {"cut", {"cut", prism, "--necks", "-o", path("c.glb")}},
      {"bottleneck", {"bottleneck", prism, "0", "1"}},
      {"profile", {"profile", prism, "0", "1"}},
      {"retrieve", {"retrieve", path("shapes"), "-o", path("report"), "--descriptors", "igf"}},
      {"signature", {"signature", prism, "-o", path("s.csv")}},
      {"compare", {"compare", prism, prism}},
      {"study accuracy", {"study", "accuracy", prism}},
      {"study robustness", {"study", "robustness", prism}}};
  for (const auto& [name, help] : readingCommands()) {
    ASSERT_TRUE(arguments.count(name) == 1) << name;
    // The prism is one component, and its numbers have no unit.
    for (const auto& [more, words] : {std::pair<std::vector<std::string>, const char*>{
                                          {"--component", "7"}, "there is no component 7"},
                                      {{"--in", "cm"}, "unit of the file's numbers is not known"},
                                      {{"--weld", "thick"}, "\"thick\" is not a length"},
                                      {{"--entry", "a.obj"}, "it is no zip"}}) {
      std::vector<std::string> all = arguments.at(name);
      all.insert(all.end(), more.begin(), more.end());
      const Outcome outcome = run(all);
      EXPECT_NE(outcome.exitCode, 0) << name << " " << more[0];
      EXPECT_TRUE(contains(outcome.errors, words)) << name << " " << more[0] << outcome.errors;
    }
  }
}

TEST_F(ModelOptions, manyModelsHaveJobsOrTheHelpSaysWhyNot) {
  std::vector<std::string> withJobs, without;
  for (const auto& [name, help] : readingCommands()) {
    const bool hasJobs = contains(help, "  --jobs N ");
    if (hasJobs) withJobs.push_back(name);
    if (!contains(usageIn(help), "MODEL...") && !contains(usageIn(help), "DIR...")) {
      EXPECT_FALSE(hasJobs) << name << " takes one model";
      continue;
    }
    if (hasJobs) continue;
    without.push_back(name);
    const std::size_t note = help.find("\nMany models:\n");
    ASSERT_NE(note, std::string::npos) << name;
    EXPECT_TRUE(contains(help.substr(note), "no --jobs")) << name;
  }
  EXPECT_EQ(withJobs, (std::vector<std::string>{"igf", "info"}));
  EXPECT_EQ(without, (std::vector<std::string>{"compare", "retrieve", "study accuracy"}));
}

}  // namespace
}  // namespace girth::test
