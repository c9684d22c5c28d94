// Failures are values: what went wrong, at which element, and what to do about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "girth/export.h"

namespace girth {

/// The codes of failures. The table with texts, exit codes and remedies is `error_codes.def`.
enum class ErrorCode : std::uint8_t {
#define GIRTH_ERROR_CODE(name, text, exitCode, hint) name,
#include "girth/error_codes.def"
#undef GIRTH_ERROR_CODE
};

/// The code as it is printed and as JavaScript sees it, for example "OPEN_EDGE".
GIRTH_EXPORT std::string_view toString(ErrorCode code);

/// The exit code with which the command ends: 1 usage, 2 bad input, 3 limit or cancelled.
GIRTH_EXPORT int exitCodeOf(ErrorCode code);

/// A failure.
struct GIRTH_EXPORT Error {
  /// The kind of failure.
  ErrorCode code{ErrorCode::Internal};
  /// The first offending element: a vertex, face, line or byte, as the message states. -1: none.
  std::int64_t element{-1};
  /// The fault and its place, in words: "edge 3–7 of face 12 has no face on its other side".
  std::string message{};
  /// The remedy.
  std::string hint{};
  /// The file that it is about, where a path was given; otherwise empty.
  std::string file{};

  /// All of it on one line, for people: "chair.obj: OPEN_EDGE: edge 3–7 of face 12 has no face on
  /// its other side; close the holes: every edge needs a face on both sides".
  std::string text() const;
};

/// An error with the general remedy of its code.
GIRTH_EXPORT Error makeError(ErrorCode code, std::int64_t element, std::string message);

/// A failure that nobody looked at before its value was asked for: an Error that is thrown. It is
/// caught as `const girth::Error&`, with all that it has, or as `const std::exception&`.
class GIRTH_EXPORT ThrownError : public Error, public std::exception {
 public:
  /// Throws that failure.
  explicit ThrownError(Error error);
  ~ThrownError() override;
  /// Copied with its text.
  ThrownError(const ThrownError&);
  /// Assigned with its text.
  ThrownError& operator=(const ThrownError&);

  /// Error::text.
  const char* what() const noexcept override;

 private:
  std::string text_;
};

/// Throws the failure as a ThrownError.
[[noreturn]] GIRTH_EXPORT void throwError(const Error& error);
/// Throws std::logic_error: an error was asked for where there is a value.
[[noreturn]] GIRTH_EXPORT void throwNoError();

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
  /// Whether there is a value, as ok().
  explicit operator bool() const { return ok(); }

  /// The value. Where there is none, the error is thrown (ThrownError).
  T& value() & {
    requireValue();
    return *std::get_if<0>(&content_);
  }
  /// The value, not to be changed.
  const T& value() const& {
    requireValue();
    return *std::get_if<0>(&content_);
  }
  /// The value, moved out of a result that is going: a value of its own, so that `const auto& mesh
  /// = SurfaceMesh::fromArrays(...).value();` lasts.
  T value() && {
    requireValue();
    return std::move(*std::get_if<0>(&content_));
  }

  /// The error. Where there is none, std::logic_error is thrown.
  const Error& error() const& {
    requireError();
    return *std::get_if<1>(&content_);
  }
  /// The error, moved out of a result that is going.
  Error error() && {
    requireError();
    return std::move(*std::get_if<1>(&content_));
  }

 private:
  void requireValue() const {
    if (!ok()) throwError(*std::get_if<1>(&content_));
  }
  void requireError() const {
    if (ok()) throwNoError();
  }

  std::variant<T, Error> content_;
};

}  // namespace girth
