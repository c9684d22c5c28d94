// Words of the command about itself and about slips.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

TEST_F(Command, helpOfACommandIsTheSameBothWays) {
  const Outcome help = run({"help", "igf"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.output, run({"igf", "--help"}).output);
  EXPECT_EQ(help.output, run({"igf", "-h"}).output);
  EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
  EXPECT_EQ(run({"help", "study", "accuracy"}).output, run({"study", "accuracy", "-h"}).output);
}

TEST_F(Command, everyCommandHasExamplesAndExitCodes) {
  std::vector<std::vector<std::string>> commands;
  bool isList = false;
  for (const std::string& line : linesOf(run({"help"}).output)) {
    if (line.empty()) isList = false;
    if (isList && line[2] != ' ') commands.push_back({line.substr(2, line.find(' ', 2) - 2)});
    if (line == "Commands:") isList = true;
  }
  EXPECT_GE(commands.size(), 12u);
  commands.push_back({"study", "accuracy"});
  commands.push_back({"study", "robustness"});
  for (std::vector<std::string> command : commands) {
    if (command[0] == "study" && command.size() == 1) continue;
    command.insert(command.begin(), "help");
    const std::string help = run(command).output;
    const std::size_t examples = help.find("\nExamples:\n");
    ASSERT_NE(examples, std::string::npos) << help;
    std::size_t count = 0;
    for (std::size_t at = examples; (at = help.find("\n  girth ", at)) != std::string::npos; ++at) {
      ++count;
    }
    EXPECT_GE(count, 2u) << help;
    for (const char* code : {"0 done", "1 wrong usage", "2 bad input", "3 a limit", "4 a check"}) {
      EXPECT_TRUE(contains(help, code)) << code << "\n" << help;
    }
  }
}

TEST_F(Command, exitCodesOfTheDocumentAreThoseOfTheHelp) {
  const std::string help = run({"help"}).output;
  std::string words = help.substr(help.find("Exit codes: "));
  std::replace(words.begin(), words.end(), '\n', ' ');
  std::size_t found = 0;
  for (const std::string& line : linesOf(contentOf(kData + "/../../web/docs/command.md"))) {
    if (line.size() < 4 || line[0] != '|' || line[2] < '0' || line[2] > '9') continue;
    const std::size_t from = line.find_first_not_of(" |", 3);
    const std::size_t to = line.find_last_not_of(" |");
    EXPECT_TRUE(contains(words, line.substr(2, 1) + " " + line.substr(from, to + 1 - from)))
        << line;
    ++found;
  }
  EXPECT_EQ(found, 5u);
}

TEST_F(Command, slipsAreAnsweredWithWhatWasMeant) {
  const std::string prism = kData + "/prism.obj";
  const struct {
    std::vector<std::string> arguments;
    const char* words;
  } cases[]{{{"ifg", prism}, "did you mean igf?"},
            {{"igf", prism, "--facess", "9"}, "did you mean --faces?"},
            {{"igf", prism, "--ouptut=a.csv"}, "did you mean --output?"},
            {{"igf", prism, "--method", "exat"}, "did you mean exact?"},
            {{"study", "acuracy"}, "did you mean accuracy?"},
            {{"igf", prism, "--zzz"}, "see girth igf --help"},
            {{"zzzzzz"}, "see girth --help"},
            {{"study"}, "see girth study --help"},
            {{"igf", prism, "-o"}, "-o needs FILE"},
            {{"igf", prism, "-o", "--json"}, "-o needs FILE"},
            {{"igf", prism, "--json=1"}, "--json takes no value"},
            {{"igf", prism, "--threads", "1.5"}, "no whole number"},
            {{"igf", prism, "--faces", "99999999999999"}, "not between 4 and 100000000"},
            {{"loop", prism, "1", "2"}, "one argument too many"},
            {{"loop", prism, "--at", "1,0,0"}, "--at needs --face"}};
  for (const auto& [arguments, words] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << words << "\n" << outcome.errors;
  }
}

TEST_F(Command, optionsWithoutEffectAreRefusedWithTheReason) {
  const std::string prism = kData + "/prism.obj";
  const struct {
    std::vector<std::string> arguments;
    const char* words;
  } cases[]{{{"field", prism, "--field", "sdf", "--time", "3"},
             "--time has an effect on --field hks only"},
            {{"field", prism, "--field", "sdf", "--pairs", "7"},
             "--pairs has an effect on --field hks, sihks and wks only; leave it out"},
            {{"field", prism, "--field", "angle", "--rays", "9"},
             "--rays has an effect on --field sdf only"},
            {{"field", prism, "--field", "sdf", "--exact"},
             "--exact has an effect on --field geoaverage and geofarthest only"},
            {{"field", prism, "--field", "sdf", "--persistence", "1%"},
             "--persistence has an effect on --field angle only"},
            {{"igf", prism, "--method", "ms", "--audit", "3"},
             "--audit has an effect on --method refined only"},
            {{"igf", prism, "--audit", "3"}, "--audit has an effect on --method refined only"},
            {{"cut", prism, "3", "--min-prominence", "2"},
             "--min-prominence has an effect on --neck and --necks only"}};
  for (const auto& [arguments, words] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << words << "\n" << outcome.errors;
  }
  EXPECT_EQ(run({"field", prism, "--field", "sdf", "--rays", "9"}).exitCode, 0);
  EXPECT_EQ(run({"igf", prism, "--audit", "3", "--method", "refined"}).exitCode, 0);
}

TEST_F(Command, withoutACommandThereIsHelp) {
  const Outcome alone = run({});
  EXPECT_EQ(alone.output, run({"--help"}).output);
  EXPECT_EQ(alone.exitCode, 1);
  EXPECT_EQ(alone.errors, "");
}

TEST_F(Command, unitsAreGivenByTheirSymbolOrTheirName) {
  const std::string prism = kData + "/prism.obj";
  const auto with = [&](const std::string& unit) {
    return run({"info", prism, "--json", "--unit", unit}).output;
  };
  EXPECT_EQ(with("mm"), with("millimetre"));
  EXPECT_TRUE(contains(with("micrometre"), "\"unit\":\"micrometre\""));
  EXPECT_EQ(run({"info", prism, "--unit", "parsec"}).exitCode, 1);
}

TEST_F(Command, olderNamesOfOptionsDoTheSame) {
  const std::string prism = kData + "/prism.obj";
  for (const std::string command : {"parts", "segments"}) {
    const std::vector<std::string> arguments{command, prism, "--json", "--girth", "9"};
    const auto with = [&](const std::string& diameter, const std::string& labels) {
      std::vector<std::string> all = arguments;
      all.insert(all.end(), {diameter, "2", labels, "0.5"});
      return run(all).output;
    };
    EXPECT_EQ(with("--thickness", "--smooth"), with("--shape-diameter", "--smooth-labels"));
    EXPECT_NE(with("--thickness", "--smooth"), "");
    // A note says what they are called now, and help has only that.
    std::vector<std::string> older = arguments;
    older.insert(older.end(), {"--thickness", "2"});
    EXPECT_EQ(run(older).errors,
              "girth: note: --thickness is the older name of --shape-diameter, until 2.0\n");
    older.emplace_back("-q");
    EXPECT_EQ(run(older).errors, "");
    EXPECT_FALSE(contains(run({command, "--help"}).output, "--thickness"));
  }
  EXPECT_EQ(run({"tips", prism, "--json", "--refine", "200"}).output,
            run({"tips", prism, "--json", "--subdivide", "200"}).output);
}

TEST_F(Command, optionsAreReadInEveryWayThatIsUsual) {
  const std::string prism = kData + "/prism.obj";
  for (const std::vector<std::string>& ending :
       {std::vector<std::string>{"--output", path("a.csv")},
        {"--output=" + path("a.csv")},
        {"-o", path("a.csv")},
        {"-o" + path("a.csv")},
        {"-o=" + path("a.csv")}}) {
    std::vector<std::string> arguments{"igf", prism};
    arguments.insert(arguments.end(), ending.begin(), ending.end());
    EXPECT_EQ(run(arguments).exitCode, 0);
    EXPECT_TRUE(fs::remove(path("a.csv")));
  }
  // Names that begin with a dash.
  fs::copy_file(prism, path("-prism.obj"));
  const auto before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_EQ(run({"info", "--json", "--", "-prism.obj"}).exitCode, 0);
  EXPECT_EQ(run({"info", "./-prism.obj"}).exitCode, 0);
  EXPECT_EQ(run({"info", "-prism.obj"}).exitCode, 1);
  fs::current_path(before);
}

TEST_F(Command, quietPrintsErrorsOnly) {
  const std::string prism = kData + "/prism.obj";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"igf", prism, "-q"},
                                                    {"-q", "igf", prism},
                                                    {"info", "--quiet", prism},
                                                    {"parts", prism, "-q"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.output + outcome.errors, "");
  }
  EXPECT_FALSE(run({"igf", prism, "-q", "--json"}).output.empty());
  EXPECT_TRUE(contains(run({"igf", path("none.obj"), "-q"}).errors, "FILE_NOT_FOUND"));
  EXPECT_EQ(run({"-V"}).output, run({"--version"}).output);
}

}  // namespace
}  // namespace girth::test
