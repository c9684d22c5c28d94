#include "study/shard.h"

#include <algorithm>
#include <cmath>

#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {

Result<Shard> parseShard(const std::string& text) {
  constexpr double kMostShards = 1e6;
  const auto wholeNumber = [](const std::string& digits) {
    const double value = io::parseNumber(digits).value_or(-1);
    return value >= 0 && value <= kMostShards && value == std::floor(value) ? value : -1;
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  const double number = wholeNumber(text.substr(0, slash));
  const double count = wholeNumber(slash < text.size() ? text.substr(slash + 1) : "");
  if (number < 0 || number >= count) {
    return usageError("\"" + text + "\" is no share", "use --shard I/N with I from 0 to N - 1");
  }
  return Shard{static_cast<std::size_t>(number), static_cast<std::size_t>(count)};
}

}  // namespace girth::cli
