// The table of a command's options and arguments, with examples of its use. Help, manual
// pages, completions and the messages about wrong usage are all made of this table; so it is a
// table of our own, and not one of a library that only parses.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace girth::cli {

/// One option of a command, or one of its arguments.
class Option {
 public:
  /// Takes one value, and returns what is wrong with it; empty: nothing.
  using Store = std::function<std::string(const std::string& value)>;

  /// How many values may be given.
  enum class Values { None, One, Many };

  /// `declaration`: names with commas between, then what stands for the value: "-o,--output FILE",
  /// "--json"; of an argument only the latter: "MODEL".
  Option(std::string_view declaration, std::string text, Values values, Store store);

  Option& required();
  /// Has an older name too, which help leaves out and a note points away from.
  Option& formerly(std::string name);
  /// Numbers from `least` to `greatest` only.
  Option& range(double least, double greatest);
  /// These values only.
  Option& oneOf(std::vector<std::string> choices);
  /// Several values in one, with commas between.
  Option& separated();
  /// Takes the arguments that follow as values, up to the next option.
  Option& greedy();
  /// Cannot be given together with another, by its name.
  Option& excludes(std::string other);
  /// Can be given only together with another, by its name.
  Option& needs(std::string other);
  /// Has an effect only where another option, by its name, has one of these values; is refused
  /// elsewhere.
  Option& onlyFor(std::string other, std::vector<std::string> values);

  /// The older name; empty where there is none.
  const std::string& formerName() const { return formerName_; }
  /// Whether it was given by that name.
  bool isFormerNameTyped() const { return formerNameTyped_; }
  void typedBy(std::string_view name) { formerNameTyped_ |= !name.empty() && name == formerName_; }
  /// "-o", "--output"; none for an argument.
  const std::vector<std::string>& names() const { return names_; }
  /// The name of the value in help: "FILE"; empty for a flag.
  const std::string& valueName() const { return valueName_; }
  const std::string& text() const { return text_; }
  const std::vector<std::string>& choices() const { return choices_; }
  bool isArgument() const { return names_.empty(); }
  bool isFlag() const { return values_ == Values::None; }
  bool takesMany() const { return values_ == Values::Many; }
  bool isRequired() const { return required_; }
  bool isGreedy() const { return greedy_; }
  bool isGiven() const { return given_; }
  const std::string& excluded() const { return excluded_; }
  const std::string& needed() const { return needed_; }
  /// The option and the values of `onlyFor`; none: always.
  const std::string& decider() const { return decider_; }
  const std::vector<std::string>& deciding() const { return deciding_; }
  /// The value that was given last, as typed.
  const std::string& typed() const { return typed_; }
  bool hasName(std::string_view name) const;
  /// The longest name, or what stands for an argument.
  const std::string& title() const;

  /// Takes a value that was given (of a flag: an empty one), and returns what is wrong with it.
  std::string take(const std::string& value);

 private:
  std::string takeOne(const std::string& value);

  std::vector<std::string> names_;
  std::string valueName_, formerName_;
  std::string text_;
  Values values_;
  Store store_;
  std::vector<std::string> choices_;
  bool hasRange_{false}, formerNameTyped_{false};
  double least_{0}, greatest_{0};
  bool required_{false}, separated_{false}, greedy_{false}, given_{false};
  std::string excluded_, needed_, decider_, typed_;
  std::vector<std::string> deciding_;
};

/// A line to copy, and what it does.
struct Example {
  std::string line, meaning;
};

/// A paragraph of guidance.
struct Note {
  std::string title, text;
};

class OptionTable {
 public:
  /// An option whose value is kept in `target`: a bool (a flag), a string, a number, an optional
  /// whole number, or a vector of strings or numbers, which then has the values that were given.
  /// `target` must live until the command has run.
  template <typename T>
  Option& add(std::string_view declaration, T& target, std::string text);

  /// A flag that does something.
  Option& onFlag(std::string_view declaration, std::function<void()> then, std::string text);

  /// An option whose value is taken by a function, which returns what is wrong with it.
  Option& onValue(std::string_view declaration, Option::Store store, std::string text);

  /// Two or three of them stand in every command's help.
  void example(std::string line, std::string meaning) {
    examples_.push_back({std::move(line), std::move(meaning)});
  }

  /// Advice on choices and costs: a paragraph of the help, with a title of a word or
  /// two.
  void note(std::string title, std::string text) {
    notes_.push_back({std::move(title), std::move(text)});
  }

  std::deque<Option>& options() { return options_; }
  const std::deque<Option>& options() const { return options_; }
  const std::vector<Example>& examples() const { return examples_; }
  const std::vector<Note>& notes() const { return notes_; }

 private:
  std::deque<Option> options_;  // its elements stay where they are
  std::vector<Example> examples_;
  std::vector<Note> notes_;
};

}  // namespace girth::cli
