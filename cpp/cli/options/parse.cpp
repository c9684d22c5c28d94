#include "options/parse.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "process/report.h"

namespace girth::cli {
namespace {

/// How many letters must be added, left out, replaced or exchanged with their neighbours to make
/// one word of another (the restricted Damerau-Levenshtein distance).
std::size_t editDistance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> before, last, row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    before = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row.back();
}

bool looksLikeOption(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && argument[1] != '.' &&
         (argument[1] < '0' || argument[1] > '9');
}

/// One reading of a command's arguments.
class Parsing {
 public:
  Parsing(OptionTable& table, std::span<const std::string> arguments, const std::string& command)
      : table_(table), arguments_(arguments), command_(command) {}

  std::optional<Error> all() {
    bool onlyArguments = false;
    while (at_ < arguments_.size()) {
      const std::string& argument = arguments_[at_++];
      if (argument == "--" && !onlyArguments) {
        onlyArguments = true;
        continue;
      }
      const bool isOption = !onlyArguments && looksLikeOption(argument);
      if (auto error = isOption ? takeOption(argument) : takeArgument(argument)) return error;
    }
    return checkGiven();
  }

 private:
  Error wrong(const std::string& what) const {
    return usageError(what, "see " + command_ + " --help");
  }

  Option* find(std::string_view name) {
    auto& options = table_.options();
    const auto found = std::find_if(options.begin(), options.end(), [&](const Option& option) {
      return !option.isArgument() && option.hasName(name);
    });
    return found == options.end() ? nullptr : &*found;
  }

  std::optional<Error> unknownOption(const std::string& name) const {
    std::vector<std::string> names;
    for (const Option& option : table_.options()) {
      names.insert(names.end(), option.names().begin(), option.names().end());
    }
    const std::string near = nearestName(name, names);
    const std::string what = command_ + " has no option " + name;
    return near.empty() ? wrong(what) : usageError(what, "did you mean " + near + "?");
  }

  std::optional<Error> takeOption(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    std::string name = argument.substr(0, equals);
    std::optional<std::string> value;
    if (equals != std::string::npos) value = argument.substr(equals + 1);
    Option* option = find(name);
    if (option == nullptr && argument[1] != '-') {
      // "-ofile"
      name = argument.substr(0, 2);
      option = find(name);
      if (option != nullptr && option->isFlag()) option = nullptr;
      value = argument.substr(2);
    }
    if (option == nullptr) return unknownOption(argument.substr(0, equals));
    if (option->isFlag()) {
      if (value) return wrong(name + " takes no value");
      return taken(*option, name, "");
    }
    if (!value) {
      if (at_ == arguments_.size() || isKnownOption(arguments_[at_])) {
        return wrong(name + " needs " + option->valueName() + " behind it");
      }
      value = arguments_[at_++];
    }
    if (auto error = taken(*option, name, *value)) return error;
    while (option->isGreedy() && at_ < arguments_.size() && !looksLikeOption(arguments_[at_])) {
      if (auto error = taken(*option, name, arguments_[at_++])) return error;
    }
    return std::nullopt;
  }

  bool isKnownOption(const std::string& argument) {
    return looksLikeOption(argument) && find(argument.substr(0, argument.find('='))) != nullptr;
  }

  std::optional<Error> takeArgument(const std::string& argument) {
    for (Option& option : table_.options()) {
      if (!option.isArgument() || (option.isGiven() && !option.takesMany())) continue;
      return taken(option, option.valueName(), argument);
    }
    return wrong("\"" + argument + "\" is one argument too many");
  }

  std::optional<Error> taken(Option& option, const std::string& name, const std::string& value) {
    option.typedBy(name);
    const std::string fault = option.take(value);
    if (fault.empty()) return std::nullopt;
    const std::string near = nearestName(value, option.choices());
    if (!near.empty()) return usageError(name + ": " + fault, "did you mean " + near + "?");
    return wrong(name + ": " + fault);
  }

  bool isGiven(const std::string& name) const {
    return std::any_of(table_.options().begin(), table_.options().end(), [&](const Option& option) {
      return option.hasName(name) && option.isGiven();
    });
  }

  std::optional<Error> checkGiven() const {
    for (const Option& option : table_.options()) {
      const std::string& name = option.title();
      if (!option.isGiven()) {
        if (option.isRequired()) return wrong(name + " is missing");
        continue;
      }
      if (!option.excluded().empty() && isGiven(option.excluded())) {
        return wrong(name + " and " + option.excluded() + " cannot be given together");
      }
      if (!option.needed().empty() && !isGiven(option.needed())) {
        return wrong(name + " needs " + option.needed() + " too");
      }
      if (auto error = checkEffect(option)) return error;
    }
    return std::nullopt;
  }

  /// Refuses an option that has no effect beside the others.
  std::optional<Error> checkEffect(const Option& option) const {
    if (option.decider().empty()) return std::nullopt;
    const auto& options = table_.options();
    const auto decider = std::find_if(options.begin(), options.end(), [&](const Option& other) {
      return other.hasName(option.decider());
    });
    const std::vector<std::string>& values = option.deciding();
    const std::string typed = decider == options.end() ? "" : decider->typed();
    if (std::find(values.begin(), values.end(), typed) != values.end()) return std::nullopt;
    std::string listed;
    for (const std::string& value : values) {
      listed += (listed.empty() ? " " : &value == &values.back() ? " and " : ", ") + value;
    }
    return usageError(option.title() + " has an effect on " + option.decider() + listed + " only",
                      "leave it out");
  }

  OptionTable& table_;
  std::span<const std::string> arguments_;
  const std::string& command_;
  std::size_t at_{0};
};

}  // namespace

std::string nearestName(const std::string& typed, std::span<const std::string> names) {
  std::string nearest;
  std::size_t least = 1 + std::max<std::size_t>(1, typed.size() / 3);
  for (const std::string& name : names) {
    const std::size_t distance = editDistance(typed, name);
    if (name.size() > 2 && distance < least && distance < name.size()) {
      least = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::optional<Error> parseArguments(OptionTable& table, std::span<const std::string> arguments,
                                    const std::string& command) {
  return Parsing(table, arguments, command).all();
}

}  // namespace girth::cli
