#include "girth/error.h"

#include <stdexcept>

namespace girth {

namespace {

struct CodeRow {
  std::string_view text;
  int exitCode;
  std::string_view hint;
};

constexpr CodeRow kRows[] = {
#define GIRTH_ERROR_CODE(name, text, exitCode, hint) {text, exitCode, hint},
#include "girth/error_codes.def"
#undef GIRTH_ERROR_CODE
};

const CodeRow& rowOf(ErrorCode code) { return kRows[static_cast<std::size_t>(code)]; }

}  // namespace

std::string_view toString(ErrorCode code) { return rowOf(code).text; }

int exitCodeOf(ErrorCode code) { return rowOf(code).exitCode; }

Error makeError(ErrorCode code, std::int64_t element, std::string message) {
  return {code, element, std::move(message), std::string(rowOf(code).hint)};
}

std::string Error::text() const {
  std::string text = file.empty() ? "" : file + ": ";
  text += std::string(toString(code)) + ": " + message;
  if (!hint.empty()) text += "; " + hint;
  return text;
}

ThrownError::ThrownError(Error error) : Error(std::move(error)), text_(Error::text()) {}
ThrownError::~ThrownError() = default;
ThrownError::ThrownError(const ThrownError&) = default;
ThrownError& ThrownError::operator=(const ThrownError&) = default;

const char* ThrownError::what() const noexcept { return text_.c_str(); }

void throwError(const Error& error) { throw ThrownError(error); }

void throwNoError() {
  throw std::logic_error("girth: an error was asked for where there is a value");
}

}  // namespace girth
