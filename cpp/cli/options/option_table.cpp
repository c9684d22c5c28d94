#include "options/option_table.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <system_error>

#include "text/number_text.h"

namespace girth::cli {
namespace {

std::vector<std::string> splitAtCommas(std::string_view text) {
  std::vector<std::string> pieces;
  for (std::size_t at = 0;;) {
    const std::size_t comma = text.find(',', at);
    pieces.emplace_back(text.substr(at, comma - at));
    if (comma == std::string_view::npos) return pieces;
    at = comma + 1;
  }
}

/// One value's way into memory: `read` returns what is wrong with it.
template <typename T>
struct Value {
  static constexpr Option::Values kValues = Option::Values::One;
  static std::string read(const std::string& text, T& target) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), target);
    const bool isWhole = end == text.data() + text.size() && !text.empty();
    if (isWhole && problem == std::errc()) return "";
    if (isWhole && problem == std::errc::result_out_of_range) return text + " is too large";
    return "\"" + text + "\" is no whole number" + (std::is_unsigned_v<T> ? " of at least 0" : "");
  }
};

template <>
struct Value<bool> {
  static constexpr Option::Values kValues = Option::Values::None;
  static std::string read(const std::string&, bool& target) {
    target = true;
    return "";
  }
};

template <>
struct Value<std::string> {
  static constexpr Option::Values kValues = Option::Values::One;
  static std::string read(const std::string& text, std::string& target) {
    target = text;
    return "";
  }
};

template <>
struct Value<double> {
  static constexpr Option::Values kValues = Option::Values::One;
  static std::string read(const std::string& text, double& target) {
    const std::optional<double> number = io::parseNumber(text);
    if (!number) return "\"" + text + "\" is no number";
    target = *number;
    return "";
  }
};

template <typename T>
struct Value<std::optional<T>> {
  static constexpr Option::Values kValues = Option::Values::One;
  static std::string read(const std::string& text, std::optional<T>& target) {
    return Value<T>::read(text, target.emplace());
  }
};

template <typename T>
struct Value<std::vector<T>> {
  static constexpr Option::Values kValues = Option::Values::Many;
  static std::string read(const std::string& text, std::vector<T>& target) {
    return Value<T>::read(text, target.emplace_back());
  }
};

}  // namespace

Option::Option(std::string_view declaration, std::string text, Values values, Store store)
    : text_(std::move(text)), values_(values), store_(std::move(store)) {
  const std::size_t blank = declaration.find(' ');
  const std::string_view first = declaration.substr(0, blank);
  if (first.front() == '-') {
    names_ = splitAtCommas(first);
    if (blank != std::string_view::npos) valueName_ = declaration.substr(blank + 1);
  } else {
    valueName_ = declaration;
  }
}

Option& Option::required() {
  required_ = true;
  return *this;
}

Option& Option::range(double least, double greatest) {
  hasRange_ = true;
  least_ = least;
  greatest_ = greatest;
  return *this;
}

Option& Option::oneOf(std::vector<std::string> choices) {
  choices_ = std::move(choices);
  return *this;
}

Option& Option::separated() {
  separated_ = true;
  return *this;
}

Option& Option::greedy() {
  greedy_ = true;
  return *this;
}

Option& Option::excludes(std::string other) {
  excluded_ = std::move(other);
  return *this;
}

Option& Option::formerly(std::string name) {
  formerName_ = std::move(name);
  return *this;
}

Option& Option::needs(std::string other) {
  needed_ = std::move(other);
  return *this;
}

Option& Option::onlyFor(std::string other, std::vector<std::string> values) {
  decider_ = std::move(other);
  deciding_ = std::move(values);
  return *this;
}

bool Option::hasName(std::string_view name) const {
  if (isArgument()) return name == valueName_;
  return (name == formerName_ && !name.empty()) ||
         std::find(names_.begin(), names_.end(), name) != names_.end();
}

const std::string& Option::title() const { return isArgument() ? valueName_ : names_.back(); }

std::string Option::take(const std::string& value) {
  given_ = true;
  typed_ = value;
  if (!separated_) return takeOne(value);
  for (const std::string& piece : splitAtCommas(value)) {
    if (std::string fault = takeOne(piece); !fault.empty()) return fault;
  }
  return "";
}

std::string Option::takeOne(const std::string& value) {
  if (!choices_.empty() && std::find(choices_.begin(), choices_.end(), value) == choices_.end()) {
    std::string fault = "\"" + value + "\" is none of ";
    for (const std::string& choice : choices_) {
      fault += (&choice == &choices_.front() ? "" : ", ") + choice;
    }
    return fault;
  }
  if (hasRange_) {
    const std::optional<double> number = io::parseNumber(value);
    if (number && !(*number >= least_ && *number <= greatest_)) {
      return value + " is not between " + io::formatNumber(least_) + " and " +
             io::formatNumber(greatest_);
    }
  }
  return store_(value);
}

template <typename T>
Option& OptionTable::add(std::string_view declaration, T& target, std::string text) {
  return options_.emplace_back(declaration, std::move(text), Value<T>::kValues,
                               [&target, isFirst = true](const std::string& value) mutable {
                                 // Values that are given replace those by default.
                                 if (isFirst && Value<T>::kValues == Option::Values::Many)
                                   target = {};
                                 isFirst = false;
                                 return Value<T>::read(value, target);
                               });
}

template Option& OptionTable::add(std::string_view, bool&, std::string);
template Option& OptionTable::add(std::string_view, std::string&, std::string);
template Option& OptionTable::add(std::string_view, double&, std::string);
template Option& OptionTable::add(std::string_view, unsigned&, std::string);
template Option& OptionTable::add(std::string_view, unsigned long&, std::string);
template Option& OptionTable::add(std::string_view, unsigned long long&, std::string);
template Option& OptionTable::add(std::string_view, std::optional<std::int64_t>&, std::string);
template Option& OptionTable::add(std::string_view, std::vector<std::string>&, std::string);
template Option& OptionTable::add(std::string_view, std::vector<std::uint32_t>&, std::string);
template Option& OptionTable::add(std::string_view, std::vector<double>&, std::string);

Option& OptionTable::onFlag(std::string_view declaration, std::function<void()> then,
                            std::string text) {
  return options_.emplace_back(declaration, std::move(text), Option::Values::None,
                               [then = std::move(then)](const std::string&) {
                                 then();
                                 return std::string();
                               });
}

Option& OptionTable::onValue(std::string_view declaration, Option::Store store, std::string text) {
  return options_.emplace_back(declaration, std::move(text), Option::Values::One, std::move(store));
}

}  // namespace girth::cli
