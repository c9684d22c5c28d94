#include "help/help_text.h"

#include <algorithm>

#include "process/exit_codes.h"

namespace girth::cli {
namespace {

constexpr std::size_t kLineWidth = 90;
constexpr std::size_t kMeaningColumn = 26;

/// Words on lines of at most `kLineWidth` letters; all but the first are indented.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t column) {
  std::string lines;
  bool isFirst = true;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    text.remove_prefix(std::min(blank + 1, text.size()));
    if (!isFirst && column + 1 + word.size() > kLineWidth) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!isFirst) {
      lines += " ";
      ++column;
    }
    lines += word;
    column += word.size();
    isFirst = false;
  }
  return lines + "\n";
}

/// A name on the left and its meaning beside it, or below it where it is long.
std::string row(const std::string& name, const std::string& meaning) {
  std::string text = "  " + name;
  if (text.size() + 2 > kMeaningColumn) {
    text += "\n" + std::string(kMeaningColumn, ' ');
  } else {
    text.resize(kMeaningColumn, ' ');
  }
  return text + wrapped(meaning, kMeaningColumn, kMeaningColumn);
}

}  // namespace

std::string_view programSummary() {
  return "The intrinsic girth function of surfaces: the length of the shortest loop that can be "
         "drawn tight around a surface through each of its points.";
}

std::string_view modelWords() {
  return "Models are glTF, GLB, OBJ, PLY, STL or OFF files, as they are, packed by gzip or in a "
         "zip; - "
         "is standard input. All numbers count from 0: vertices and faces as in the file, tips, "
         "limbs, necks and parts as they are listed.";
}

std::string helpEnd() {
  std::string codes;
  for (const ExitCode& exit : kExitCodes) {
    codes +=
        (codes.empty() ? "Exit codes: " : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  }
  return wrapped(modelWords(), 0, 0) + wrapped(codes + ".", 0, 0);
}

std::string usageOf(const std::string& name, const OptionTable& table) {
  std::string arguments, options;
  bool hasMore = false;
  for (const Option& option : table.options()) {
    const std::string several = option.takesMany() ? "..." : "";
    if (option.isArgument()) {
      arguments += option.isRequired() ? " " + option.valueName() + several
                                       : " [" + option.valueName() + several + "]";
    } else if (option.isRequired()) {
      options += " " + option.names().front() + " " + option.valueName();
    } else {
      hasMore = true;
    }
  }
  return name + arguments + options + (hasMore ? " [options]" : "");
}

std::string declarationOf(const Option& option) {
  std::string text;
  for (const std::string& name : option.names()) text += (text.empty() ? "" : ", ") + name;
  if (option.isFlag()) return text;
  return text + (text.empty() ? "" : " ") + option.valueName();
}

std::string meaningOf(const Option& option) {
  return option.text() + (option.isRequired() && !option.isArgument() ? " (required)" : "");
}

std::string helpOf(const std::string& name, const Command& command, const OptionTable& table) {
  std::string text = wrapped(std::string(command.summary) + ".", 0, 0);
  text += "\nUsage: " + usageOf(name, table) + "\n";
  std::string arguments, options;
  for (const Option& option : table.options()) {
    (option.isArgument() ? arguments : options) += row(declarationOf(option), meaningOf(option));
  }
  if (!arguments.empty()) text += "\nArguments:\n" + arguments;
  text += "\nOptions:\n" + options;
  for (const Note& note : table.notes()) {
    text += "\n" + note.title + ":\n  " + wrapped(note.text, 2, 2);
  }
  if (!table.examples().empty()) text += "\nExamples:\n";
  for (const Example& example : table.examples()) {
    text += "  " + example.line + "\n      " + wrapped(example.meaning, 6, 6);
  }
  return text + "\n" + helpEnd();
}

std::string helpOfCommands(const std::string& name, std::span<const Command* const> commands) {
  std::string text = name == "girth" ? wrapped(programSummary(), 0, 0) + "\n" : std::string();
  text += "Usage: " + name + " COMMAND [arguments] [options]\n\nCommands:\n";
  for (const Command* command : commands) text += row(command->name, command->summary);
  text += "\n" + name + " COMMAND --help has a command's options and examples.\n";
  if (name == "girth") {
    text += "girth --version, -V prints the version.\n\n" + helpEnd();
  }
  return text;
}

}  // namespace girth::cli
