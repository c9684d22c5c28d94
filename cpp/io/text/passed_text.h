// Text behind all that a file's format knows, which is passed over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace girth::io {

/// Counts the lines with such text, and remembers the first word of it.
class PassedText {
 public:
  /// `word` on `line` is passed over. Lines come in ascending order.
  void add(std::string_view word, std::int64_t line);

  std::size_t lines() const { return lines_; }
  /// The first of them; 0 where there are none.
  std::int64_t firstLine() const { return firstLine_; }

  /// A sentence for the user: how many lines, and where the first is. Only where there are any.
  std::string note() const;

 private:
  std::size_t lines_{0};
  std::int64_t firstLine_{0};
  std::int64_t lastLine_{0};
  std::string firstWord_;
};

}  // namespace girth::io
