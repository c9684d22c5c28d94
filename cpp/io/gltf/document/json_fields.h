// The members of JSON objects, with their types checked and with the place of what is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"

namespace girth::io {

/// Where a value stands in a document. Cheap until somebody asks for its name; what is above must
/// outlive it.
class JsonPlace {
 public:
  /// The document itself.
  JsonPlace() = default;
  JsonPlace(const JsonPlace& above, std::string_view member) : above_(&above), member_(member) {}
  JsonPlace(const JsonPlace& above, std::size_t element) : above_(&above), element_(element) {}

  /// As a JSON pointer (RFC 6901): "/accessors/3/bufferView".
  std::string pointer() const;

 private:
  const JsonPlace* above_{nullptr};
  std::string_view member_;
  std::size_t element_{0};
};

/// The largest number of an element of a list.
constexpr std::uint64_t kMostReference = std::numeric_limits<std::int32_t>::max();

/// The members of one object. The first fault is kept in `fault`, which everyone who reads a
/// document shares; after one, values are of no use, but still safe.
class JsonFields {
 public:
  /// All three must outlive the object. A value that is no object is a fault, and has no members.
  JsonFields(const nlohmann::json& value, const JsonPlace& place, std::optional<Error>& fault);

  const JsonPlace& place() const { return place_; }
  std::optional<Error>& fault() const { return fault_; }

  /// All members; nothing where the value is no object.
  const nlohmann::json* object() const { return object_; }

  /// The member, or nothing; null is taken for nothing.
  const nlohmann::json* find(const char* name) const;

  /// A whole number of at least 0 and at most `most`; 3.0 is one, as JSON has one kind of number.
  std::optional<std::uint64_t> integer(const char* name, std::uint64_t most) const;
  /// A whole number whose absence is a fault.
  std::uint64_t requiredInteger(const char* name, std::uint64_t most) const;
  /// The number of an element of another list: not checked whether there is one.
  std::optional<std::uint32_t> reference(const char* name) const;
  std::vector<std::uint32_t> references(const char* name) const;
  /// Numbers; where `size` is not 0, exactly so many.
  std::vector<double> numbers(const char* name, std::size_t size) const;
  bool flag(const char* name) const;
  /// Text; empty where there is none.
  std::string text(const char* name) const;

  /// Notes a fault of this object, or of the member of that name.
  void report(const std::string& what, const char* name = nullptr) const;

 private:
  std::optional<std::uint64_t> integerOf(const nlohmann::json& value, const JsonPlace& place,
                                         std::uint64_t most) const;

  const nlohmann::json* object_{nullptr};
  const JsonPlace& place_;
  std::optional<Error>& fault_;
};

/// Calls `read(element, place)` for every element of the array of that name; no array at all is an
/// empty one.
template <class Read>
void forEachElement(const JsonFields& fields, const char* name, const Read& read) {
  const nlohmann::json* list = fields.find(name);
  if (list == nullptr) return;
  const JsonPlace listPlace(fields.place(), name);
  if (!list->is_array()) {
    fields.report("is not an array", name);
    return;
  }
  std::size_t number = 0;
  for (const nlohmann::json& element : *list) {
    read(element, JsonPlace(listPlace, number++));
    if (fields.fault()) return;
  }
}

}  // namespace girth::io
