// The tables of web/docs/outputs.md, against what the command writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

/// A command in a heading, "### `girth igf -o values.csv`", and the names in its table's first
/// column.
struct Documented {
  std::vector<std::string> words, names;
};

std::vector<Documented> documentedOutputs() {
  std::vector<Documented> outputs;
  for (const std::string& line : linesOf(contentOf(kData + "/../../web/docs/outputs.md"))) {
    if (line.rfind("### `girth ", 0) == 0) {
      std::istringstream words(line.substr(5, line.rfind('`') - 5));
      outputs.emplace_back();
      for (std::string word; words >> word;) outputs.back().words.push_back(word);
    } else if (line.rfind("| `", 0) == 0 && !outputs.empty()) {
      outputs.back().names.push_back(line.substr(3, line.find('`', 3) - 3));
    }
  }
  return outputs;
}

/// The words of the first line between commas.
std::vector<std::string> headerOf(const std::string& csv) {
  std::istringstream line(linesOf(csv).at(0));
  std::vector<std::string> names;
  for (std::string name; std::getline(line, name, ',');) names.push_back(name);
  return names;
}

std::vector<std::string> membersOf(const std::string& text) {
  std::vector<std::string> members;
  const auto json = nlohmann::ordered_json::parse(text);
  for (const auto& [name, value] : json.items()) members.push_back(name);
  return members;
}

TEST_F(Command, outputsAreAsDocumented) {
  const std::string model = kData + "/prism.obj";
  const auto outputs = documentedOutputs();
  EXPECT_GE(outputs.size(), 20u);
  for (const Documented& output : outputs) {
    std::vector<std::string> arguments{output.words[1], model};
    std::string file;
    for (std::size_t i = 2; i < output.words.size(); ++i) {
      const bool isFile = output.words[i - 1] == "-o" || output.words[i - 1] == "--barcode";
      if (output.words[i] == "other.obj") {
        arguments.push_back(model);
        continue;
      }
      if (output.words[i] == "pairs.csv") {
        arguments.push_back(write("pairs.csv", "0,1\n"));
        continue;
      }
      if (isFile) file = path(output.words[i]);
      arguments.push_back(isFile ? file : output.words[i]);
    }
    const Outcome outcome = run(arguments);
    ASSERT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 4) << outcome.errors;
    const bool isPrinted = output.words.back() == "--json";
    const std::string content = isPrinted ? outcome.output : contentOf(file);
    const bool isCsv = file.find(".csv") != std::string::npos;
    EXPECT_EQ(isCsv ? headerOf(content) : membersOf(content), output.names)
        << ::testing::PrintToString(output.words);
  }
}

TEST_F(Command, partsNameTheSameInAllOutputs) {
  const std::string model = kData + "/prism.obj";
  const auto parts = nlohmann::json::parse(run({"parts", model, "--json"}).output)["parts"];
  ASSERT_EQ(run({"parts", model, "-o", path("parts.csv")}).exitCode, 0);
  const auto lines = linesOf(contentOf(path("parts.csv")));
  ASSERT_GT(parts.size(), 1u);
  std::vector<std::size_t> rows(parts.size());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = headerOf(lines[i]);
    const auto& part = parts.at(std::stoul(cells.at(4)));
    EXPECT_EQ(part["kind"], cells.at(5));
    EXPECT_TRUE(cells.at(2) == "loop" || cells.at(2) == "antipodal") << cells.at(2);
    const auto& vertices = part["vertices"];
    EXPECT_NE(std::find(vertices.begin(), vertices.end(), std::stoul(cells.at(0))), vertices.end());
    ++rows[std::stoul(cells.at(4))];
  }
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_EQ(rows[i], parts[i]["vertices"].size());
}

TEST_F(Command, unitsStandInHeadersWithPositions) {
  const std::string model = kData + "/prism.obj";
  ASSERT_EQ(run({"igf", model, "-o", path("a.csv"), "--positions", "--unit", "mm", "-q"}).exitCode,
            0);
  const auto lines = linesOf(contentOf(path("a.csv")));
  EXPECT_EQ(lines.at(0), "vertex,x (mm),y (mm),z (mm),igf (mm),kind");
  EXPECT_EQ(lines.at(1).rfind("0,-0.5,-0.5,0,", 0), 0u) << lines.at(1);
  ASSERT_EQ(run({"igf", model, "-o", path("a.json"), "--positions"}).exitCode, 0);
  const auto json = nlohmann::json::parse(contentOf(path("a.json")));
  EXPECT_EQ(json["z"].size(), json["igf"].size());
  EXPECT_EQ(json["x"][0], -0.5);
}

TEST_F(Command, theAngleOfTheLoopIsAField) {
  const std::string model = kData + "/prism.obj";
  ASSERT_EQ(run({"field", model, "--field", "angle", "-o", path("angle.json")}).exitCode, 0);
  const auto field = nlohmann::json::parse(contentOf(path("angle.json")));
  EXPECT_EQ(field["fields"][0]["unit"], "radian");
  for (const std::size_t vertex : {0u, 20u}) {
    const auto loop =
        nlohmann::json::parse(run({"loop", model, std::to_string(vertex), "--json"}).output);
    EXPECT_EQ(field["angle"][vertex], loop["angle"]);
  }
}

}  // namespace
}  // namespace girth::test
