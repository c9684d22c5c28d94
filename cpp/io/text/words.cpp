#include "text/words.h"

namespace girth::io {

std::string_view textOf(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  return text;
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

std::optional<std::int64_t> parseInteger(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    if (value < 1'000'000'000'000) value = 10 * value + (c - '0');
  }
  return negative ? -value : value;
}

bool Words::passLineEnd() {
  if (at_ == text_.size() || !isLineEnd(text_[at_])) return false;
  const bool pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  at_ += pair ? 2 : 1;
  ++line_;
  return true;
}

/// Whether here is a backslash that joins the next line on.
bool Words::joinsHere() const {
  return continuation_ == Continuation::JoinsLines && text_[at_] == '\\' &&
         (at_ + 1 == text_.size() || isLineEnd(text_[at_ + 1]));
}

std::string_view Words::nextOnLine() {
  while (at_ < text_.size()) {
    if (isBlank(text_[at_])) {
      ++at_;
    } else if (joinsHere()) {
      ++at_;
      passLineEnd();
    } else {
      break;
    }
  }
  const std::size_t begin = at_;
  if (at_ < text_.size() && text_[at_] == comment_ && comment_ != '\0') return {};
  while (at_ < text_.size() && !isBlank(text_[at_]) && !isLineEnd(text_[at_]) && !joinsHere()) {
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

std::string_view Words::next() {
  while (true) {
    const std::string_view word = nextOnLine();
    if (!word.empty() || at_ == text_.size()) return word;
    skipLine();
  }
}

void Words::skipLine() {
  while (at_ < text_.size() && !isLineEnd(text_[at_])) ++at_;
  passLineEnd();
}

bool Words::atEnd() {
  const Words here = *this;
  if (next().empty()) return true;
  *this = here;
  return false;
}

}  // namespace girth::io
