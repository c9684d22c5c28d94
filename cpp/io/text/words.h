// The words of a text file, with the lines that they stand on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// The bytes of a file as text; a byte order mark of UTF-8 is left out.
GIRTH_EXPORT std::string_view textOf(std::span<const std::byte> bytes);

/// Blank: space, tab, vertical tab, form feed. Lines end with \n, \r\n or \r, also mixed.
bool isBlank(char c);
bool isLineEnd(char c);

/// A decimal integer with an optional sign, all of `text`; nothing where it is none. A number
/// beyond 10^12 on either side comes out as such, but not exact.
GIRTH_EXPORT std::optional<std::int64_t> parseInteger(std::string_view text);

/// Takes a text apart. Nothing is copied: words stay valid as long as the text.
class Words {
 public:
  /// The meaning of a backslash at the end of a line.
  enum class Continuation : bool { No, JoinsLines };

  /// A line's rest from `comment` on is no words; '\0': there are no comments.
  explicit Words(std::string_view text, char comment = '\0',
                 Continuation continuation = Continuation::No)
      : text_(text), comment_(comment), continuation_(continuation) {}

  /// The next word, on whatever line; empty at the end of the text.
  std::string_view next();
  /// The next word of this line; empty at its end, which it does not pass.
  std::string_view nextOnLine();
  /// Passes the end of this line; not that of a line that it is joined to.
  void skipLine();

  /// Whether nothing is left but white space and comments. Passes those.
  bool atEnd();
  /// The line of the last word, from 1.
  std::int64_t line() const { return line_; }
  /// How many bytes have been passed.
  std::size_t offset() const { return at_; }

 private:
  /// Passes a line's end, if one is here.
  bool passLineEnd();
  bool joinsHere() const;

  std::string_view text_;
  std::size_t at_{0};
  std::int64_t line_{1};
  char comment_;
  Continuation continuation_;
};

}  // namespace girth::io
