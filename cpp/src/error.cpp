#include "girth/error.h"

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

}  // namespace girth
