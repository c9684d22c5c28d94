// Completions: of every command its options, their values, and files.
#include <string_view>

#include "commands/command.h"
#include "help/help_text.h"
#include "help/pages.h"

namespace girth::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The text in single quotes of a shell.
std::string shellQuoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

/// A command's words behind "girth", with its options.
struct Completed {
  std::string words;
  const Command* command;
  OptionTable table;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Option& option : table.options()) {
      all.insert(all.end(), option.names().begin(), option.names().end());
    }
    return all;
  }
};

std::vector<Completed> completedCommands() {
  constexpr std::size_t kBehindGirth = 6;
  std::vector<Completed> all;
  for (const NamedCommand& named : namedCommands()) {
    all.push_back({named.name.substr(kBehindGirth), named.command, {}});
    addOptions(*named.command, all.back().table);
  }
  return all;
}

std::vector<std::string> namesOf(std::span<const Command* const> commands) {
  std::vector<std::string> names;
  for (const Command* command : commands) names.emplace_back(command->name);
  return names;
}

/// Words that can stand where a file cannot: commands, or those below one.
std::vector<std::string> wordsBehind(const Completed& command) {
  if (command.words == "help") return namesOf(allCommands());
  return namesOf(command.command->below);
}

/// bash: the words typed so far choose the command; the word before the cursor may want a value.
std::string bashCompletion(const std::vector<Completed>& commands) {
  std::string options, behind, values;
  for (const Completed& command : commands) {
    const std::string pattern = "    " + shellQuoted(command.words) + ") ";
    options += pattern + "options=" + shellQuoted(joined(command.names())) + " ;;\n";
    if (const auto words = wordsBehind(command); !words.empty()) {
      behind += pattern + "words=" + shellQuoted(joined(words)) + " ;;\n";
    }
    for (const Option& option : command.table.options()) {
      if (option.choices().empty()) continue;
      for (const std::string& name : option.names()) {
        values += "    " + shellQuoted(command.words + " " + name) +
                  ") words=" + shellQuoted(joined(option.choices())) + " ;;\n";
      }
    }
  }
  return "# bash completion of girth\n"
         "_girth() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local command=${COMP_WORDS[1]} options= words=\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W " +
         shellQuoted(joined(namesOf(allCommands())) + " --help --version") +
         " -- \"$current\"))\n    return\n  fi\n"
         "  if [ \"$command\" = study ] && [ \"$COMP_CWORD\" -gt 2 ]; then\n"
         "    command=\"$command ${COMP_WORDS[2]}\"\n  fi\n"
         "  case \"$command $previous\" in\n" +
         values + "  esac\n  if [ -z \"$words\" ]; then\n    case \"$command\" in\n" + behind +
         "    esac\n  fi\n"
         "  if [ \"${current#-}\" != \"$current\" ]; then\n    case \"$command\" in\n" +
         options +
         "    esac\n    COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
         "  elif [ -n \"$words\" ]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  else\n    compopt -o filenames 2>/dev/null\n"
         "    COMPREPLY=($(compgen -f -- \"$current\"))\n  fi\n"
         "}\n"
         "complete -F _girth girth\n";
}

/// Text that _arguments does not read as its own signs.
std::string zshText(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zshOption(const Option& option) {
  std::string action;
  if (!option.isFlag()) {
    action = ":" + zshText(option.valueName()) + ":" +
             (option.choices().empty() ? "_files" : "(" + joined(option.choices()) + ")");
  }
  std::string lines;
  for (const std::string& name : option.names()) {
    lines += " \\\n        " + shellQuoted(name + "[" + zshText(option.text()) + "]" + action);
  }
  return lines;
}

std::string zshCompletion(const std::vector<Completed>& commands) {
  std::string list, cases;
  for (const Completed& command : commands) {
    const auto words = wordsBehind(command);
    if (command.words.find(' ') == std::string::npos) {
      list +=
          "    " + shellQuoted(std::string(command.words) + ":" + command.command->summary) + "\n";
    }
    cases += "    (" + shellQuoted(command.words) + ")\n      _arguments";
    for (const Option& option : command.table.options()) {
      if (!option.isArgument()) cases += zshOption(option);
    }
    cases += " \\\n        " +
             shellQuoted(words.empty() ? "*:file:_files" : "*:command:(" + joined(words) + ")") +
             "\n      ;;\n";
  }
  return "#compdef girth\n"
         "_girth() {\n"
         "  local -a commands\n  commands=(\n" +
         list +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n    return\n  fi\n"
         "  local command=${words[2]}\n"
         "  if [[ $command == study && CURRENT -gt 3 ]]; then\n"
         "    command=\"$command ${words[3]}\"\n  fi\n"
         "  shift words\n  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_girth \"$@\"\n";
}

/// Functions that know which command was typed: the words before the cursor, without options.
constexpr std::string_view kFishFunctions =
    "function __girth_words\n"
    "    for word in (commandline -opc)[2..-1]\n"
    "        string match -q -- '-*' $word; or echo $word\n"
    "    end\n"
    "end\n"
    "# Whether exactly these words were typed.\n"
    "function __girth_is\n"
    "    set -l words (__girth_words)\n"
    "    test \"$words\" = \"$argv\"\n"
    "end\n"
    "# Whether what was typed begins with these words.\n"
    "function __girth_in\n"
    "    set -l words (__girth_words)\n"
    "    set -l last (count $argv)\n"
    "    test \"$words[1..$last]\" = \"$argv\"\n"
    "end\n";

std::string fishOption(const Option& option) {
  std::string text;
  for (const std::string& name : option.names()) {
    text += name.size() == 2 ? " -s " + name.substr(1) : " -l " + name.substr(2);
  }
  const std::string& value = option.valueName();
  if (!option.choices().empty()) {
    text += " -x -a " + shellQuoted(joined(option.choices()));
  } else if (value == "FILE" || value == "DIR" || value == "MODEL") {
    text += " -r -F";
  } else if (!option.isFlag()) {
    text += " -x";
  }
  return text + " -d " + shellQuoted(option.text()) + "\n";
}

std::string fishCompletion(const std::vector<Completed>& commands) {
  const auto when = [](const std::string& condition) {
    return "complete -c girth -n " + shellQuoted(condition);
  };
  std::string text = "# fish completion of girth\n";
  text += kFishFunctions;
  text += when("__girth_is") + " -s h -l help -d 'Print help'\n";
  text += when("__girth_is") + " -s V -l version -d 'Print the version'\n";
  for (const Completed& command : commands) {
    const std::size_t blank = command.words.rfind(' ');
    const bool isBelow = blank != std::string::npos;
    const std::string above = isBelow ? " " + command.words.substr(0, blank) : "";
    text += when("__girth_is" + above) + " -f -a " + command.command->name + " -d " +
            shellQuoted(command.command->summary) + "\n";
    if (command.words == "help") {
      text += when("__girth_in help") + " -f\n";
      text += when("__girth_is help") + " -a " + shellQuoted(joined(wordsBehind(command))) + "\n";
    }
    const bool isAbove = !command.command->below.empty();
    const std::string typed = (isAbove ? "__girth_is " : "__girth_in ") + command.words;
    if (isAbove) {
      text += when("__girth_is help " + command.words) + " -a " +
              shellQuoted(joined(namesOf(command.command->below))) + "\n";
    }
    for (const Option& option : command.table.options()) {
      if (!option.isArgument()) text += when(typed) + fishOption(option);
    }
  }
  return text;
}

}  // namespace

std::vector<Page> completionPages() {
  const std::vector<Completed> commands = completedCommands();
  return {{"bash-completion/completions/girth", bashCompletion(commands)},
          {"zsh/site-functions/_girth", zshCompletion(commands)},
          {"fish/vendor_completions.d/girth.fish", fishCompletion(commands)}};
}

}  // namespace girth::cli
