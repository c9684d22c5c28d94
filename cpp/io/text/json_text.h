// Strings and numbers as JSON writes them.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// The text in quotes, escaped; bytes that are not UTF-8 are replaced.
GIRTH_EXPORT std::string jsonString(std::string_view text);

/// The number as `formatNumber` writes it; null where it is not finite.
std::string numberJson(double value);

}  // namespace girth::io
