// Strings, numbers and objects as JSON writes them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "girth/elements.h"
#include "girth/export.h"

namespace girth::io {

/// The text in quotes, escaped; bytes that are not UTF-8 are replaced.
GIRTH_EXPORT std::string jsonString(std::string_view text);

/// The number as `formatNumber` writes it; null where it is not finite.
GIRTH_EXPORT std::string numberJson(double value);

/// An array, written entry by entry.
class JsonList {
 public:
  /// `isByLine`: each entry stands in a line of its own.
  explicit JsonList(bool isByLine = false) : isByLine_(isByLine) {}

  /// Adds an entry, which is JSON already.
  void add(std::string_view json) {
    if (text_.size() > 1) text_ += ',';
    if (isByLine_) text_ += '\n';
    text_ += json;
  }

  /// The array with the entries so far.
  std::string text() const { return text_ + "]"; }

 private:
  bool isByLine_;
  std::string text_{"["};
};

/// An object, written member by member.
class GIRTH_EXPORT JsonObject {
 public:
  /// A number; null where it is not finite.
  JsonObject& add(std::string_view name, double value) { return addJson(name, numberJson(value)); }
  /// A count, or whether something is so.
  template <std::integral Value>
  JsonObject& add(std::string_view name, Value value) {
    if constexpr (std::is_same_v<Value, bool>) return addJson(name, value ? "true" : "false");
    return addJson(name, std::to_string(value));
  }
  /// A text.
  JsonObject& add(std::string_view name, std::string_view value) {
    return addJson(name, jsonString(value));
  }
  /// A count, or null where it is the number of no element.
  JsonObject& add(std::string_view name, Index number) {
    return addJson(name, number == kNoIndex ? "null" : std::to_string(number));
  }
  /// A value that is JSON already.
  JsonObject& addJson(std::string_view name, std::string_view value);
  /// A value that is JSON already, in a line of its own.
  JsonObject& addJsonLine(std::string_view name, std::string_view value);

  /// The object with the members so far.
  std::string text() const { return text_ + "}"; }

 private:
  std::string text_{"{"};
};

}  // namespace girth::io
