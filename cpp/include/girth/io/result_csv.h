// Results as CSV: what girth/describe lists, as far as it has a place in a row.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "girth/describe/description.h"
#include "girth/elements.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// A row of CSV, cell by cell: numbers, words and places. Members of other kinds have no cell.
class GIRTH_EXPORT CsvRow {
 public:
  /// A row that begins with `before`, cells with commas between; empty: with none.
  CsvRow(const LoadedMesh& loaded, std::string_view before) : loaded_(&loaded), text_(before) {}

  /// A number; an empty cell where it is not finite.
  void operator()(std::string_view, double number);
  /// `true` or `false`.
  void operator()(std::string_view, bool isSo) { add(isSo ? "true" : "false"); }
  /// A count.
  template <std::integral Count>
  void operator()(std::string_view, Count count) {
    add(std::to_string(count));
  }
  /// A word; in quotation marks where it has a comma, such a mark or the end of a line.
  void operator()(std::string_view, std::string_view word);
  /// A word of an enumeration.
  template <class Word>
  requires std::is_enum_v<Word>
  void operator()(std::string_view, Word word) { add(toString(word)); }
  /// The vertex of the file; empty where it was made here, or is none.
  void operator()(std::string_view, Vertex vertex);
  /// Three cells: x, y and z.
  void operator()(std::string_view, const Vec3& place);
  /// Its position.
  void operator()(std::string_view name, const SurfacePoint& place);
  /// Nothing else.
  template <class Value>
  requires(std::is_class_v<Value> && !std::is_convertible_v<Value, std::string_view>) void
  operator()(std::string_view, const Value&) {}
  /// Nothing that some results lack.
  template <class Value>
  void operator()(std::string_view, const Value*) {}

  /// The row, with the unit of lengths in a last cell.
  std::string line();

 private:
  void add(std::string_view cell);

  const LoadedMesh* loaded_;
  std::string text_;
};

/// The first line of CSV: the names of the cells.
class GIRTH_EXPORT CsvHeader {
 public:
  /// As of CsvRow.
  explicit CsvHeader(std::string_view before) : text_(before) {}

  /// Names the cells of a member of type Value: `x`, `y` and `z` of the first place, those of
  /// others with the member's name before (`normalX`).
  template <class Value>
  void add(std::string_view name) {
    constexpr bool isPlace = std::is_same_v<Value, Vec3> || std::is_same_v<Value, SurfacePoint>;
    if constexpr (isPlace) {
      addPlace(name);
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value> ||
                         std::is_same_v<Value, Vertex> ||
                         std::is_convertible_v<Value, std::string_view>) {
      addName(name);
    }
  }

  /// The line, with `unit` at its end.
  std::string line();

 private:
  void addName(std::string_view name);
  void addPlace(std::string_view name);

  std::string text_;
  bool hasPlace_{false};
};

/// Rows of results of one struct: a column for each member that is a number, a word or a place, in
/// the order of girth/describe, and `unit`.
template <Described Struct>
class ResultCsv {
 public:
  /// `before`: names of columns that stand before, with commas between.
  explicit ResultCsv(const LoadedMesh& loaded, std::string_view before = {}) : loaded_(&loaded) {
    CsvHeader header(before);
    const auto addOne = [&]<class Listed>(const Listed& one) {
      if constexpr (!std::is_same_v<Listed, Unwritten>) {
        using Value = std::invoke_result_t<decltype(one.get), const Struct&>;
        header.template add<std::remove_cvref_t<Value>>(one.name);
      }
    };
    std::apply([&](const auto&... one) { (addOne(one), ...); }, describe(Members<Struct>()));
    text_ = header.line();
  }

  /// Adds a row. `before`: the cells that stand before.
  ResultCsv& add(const Struct& result, std::string_view before = {}) {
    CsvRow row(*loaded_, before);
    visitMembers(result, row);
    text_ += row.line();
    return *this;
  }

  /// The rows so far, below their header.
  const std::string& text() const { return text_; }

 private:
  const LoadedMesh* loaded_;
  std::string text_;
};

/// The last list of described structs of a result, as CSV: a row for each, with its `number` from
/// 0.
template <Described Struct>
std::string resultCsv(const LoadedMesh& loaded, const Struct& result) {
  std::string text;
  const auto write = [&]<class Value>(const char*, const Value& value) {
    if constexpr (requires { typename Value::value_type; }) {
      if constexpr (Described<typename Value::value_type>) {
        ResultCsv<typename Value::value_type> csv(loaded, "number");
        for (std::size_t i = 0; i < value.size(); ++i) csv.add(value[i], std::to_string(i));
        text = csv.text();
      }
    }
  };
  visitMembers(result, write);
  return text;
}

}  // namespace girth::io
