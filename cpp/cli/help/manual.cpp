// Manual pages, in the macros of man(7).
#include <algorithm>

#include "commands/command.h"
#include "girth/version.h"
#include "help/help_text.h"
#include "help/pages.h"
#include "process/exit_codes.h"

namespace girth::cli {
namespace {

/// Text in which nothing is a macro or an escape.
std::string roff(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  const bool isMacro = !escaped.empty() && (escaped[0] == '.' || escaped[0] == '\'');
  return (isMacro ? "\\&" : "") + escaped;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }

/// As titles of sections are written.
std::string capitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// "girth-study-accuracy" for "girth study accuracy".
std::string pageName(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string beginOf(const std::string& name, std::string_view summary) {
  return ".TH " + pageName(name) + " 1 \"\" \"girth " + GIRTH_VERSION + "\" \"Girth\"\n.SH NAME\n" +
         roff(pageName(name)) + " \\- " + roff(summary) + "\n";
}

/// Formats and exit codes.
std::string endOfPage() {
  std::string text = ".SH FILES\n" + roff(modelWords()) + "\n.SH EXIT STATUS\n";
  for (const ExitCode& exit : kExitCodes) {
    text += ".TP\n" + bold(std::to_string(exit.code)) + "\n" + roff(exit.meaning) + "\n";
  }
  return text;
}

std::string pageOfCommand(const NamedCommand& named) {
  OptionTable table;
  addOptions(*named.command, table);
  std::string text = beginOf(named.name, named.command->summary);
  text += ".SH SYNOPSIS\n" + roff(usageOf(named.name, table)) + "\n.SH OPTIONS\n";
  for (const Option& option : table.options()) {
    text += ".TP\n" + bold(declarationOf(option)) + "\n" + roff(meaningOf(option)) + "\n";
  }
  for (const Note& note : table.notes()) {
    text += ".SH " + capitals(note.title) + "\n" + roff(note.text) + "\n";
  }
  text += ".SH EXAMPLES\n";
  for (const Example& example : table.examples()) {
    text += ".TP\n" + bold(example.line) + "\n" + roff(example.meaning) + "\n";
  }
  return text + endOfPage() + ".SH SEE ALSO\n.BR girth (1)\n";
}

}  // namespace

std::vector<Page> manualPages() {
  std::string main = beginOf("girth", "the intrinsic girth function of surfaces");
  main += ".SH SYNOPSIS\ngirth COMMAND [arguments] [options]\n.SH DESCRIPTION\n" +
          roff(programSummary()) + "\n.SH COMMANDS\n";
  std::vector<Page> pages;
  for (const NamedCommand& named : namedCommands()) {
    main += ".TP\n" + bold(named.name.substr(6)) + "\n" + roff(named.command->summary) + "\n";
    if (!named.command->below.empty()) continue;
    pages.push_back({"man/man1/" + pageName(named.name) + ".1", pageOfCommand(named)});
  }
  pages.insert(pages.begin(), {"man/man1/girth.1", main + endOfPage()});
  return pages;
}

}  // namespace girth::cli
