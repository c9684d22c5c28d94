// Failures are values: what went wrong, at which element, and what to do about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace girth {

/// What went wrong. The table with texts, exit codes and remedies is `error_codes.def`.
enum class ErrorCode : std::uint8_t {
#define GIRTH_ERROR_CODE(name, text, exitCode, hint) name,
#include "girth/error_codes.def"
#undef GIRTH_ERROR_CODE
};

/// The code as it is printed and as JavaScript sees it, for example "OPEN_EDGE".
std::string_view toString(ErrorCode code);

/// The exit code with which the command ends: 1 usage, 2 bad input, 3 limit or cancelled.
int exitCodeOf(ErrorCode code);

/// A failure.
struct Error {
  /// What went wrong.
  ErrorCode code{ErrorCode::Internal};
  /// The first offending element: a vertex, face, line or byte, as the message states. -1: none.
  std::int64_t element{-1};
  /// What is wrong and where, in words: "edge 3–7 of face 12 has no face on its other side".
  std::string message;
  /// What to do about it.
  std::string hint;
};

/// An error with the general remedy of its code.
Error makeError(ErrorCode code, std::int64_t element, std::string message);

/// A value, or the error that stands in its place.
template <class T>
class [[nodiscard]] Result {
 public:
  /// A success.
  Result(T value) : content_(std::move(value)) {}
  /// A failure.
  Result(Error error) : content_(std::move(error)) {}

  /// Whether there is a value.
  bool ok() const { return content_.index() == 0; }
  /// The same as ok().
  explicit operator bool() const { return ok(); }

  /// The value. Only where ok().
  T& value() & { return std::get<0>(content_); }
  /// The same, not to be changed.
  const T& value() const& { return std::get<0>(content_); }
  /// The same, to be moved out.
  T&& value() && { return std::get<0>(std::move(content_)); }

  /// The error. Only where not ok().
  const Error& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Error> content_;
};

}  // namespace girth
