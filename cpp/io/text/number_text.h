// Numbers as text and back: exact, and the same in every locale and on every platform.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// Whether it is one of 0 to 9, in every locale.
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// The number that `text` is, all of it, rounded correctly: decimal digits with an optional sign,
/// point and exponent. "nan" and "inf" give these values, also as Windows prints them ("1.#QNAN"),
/// and so does a number too large for a double: infinity. Nothing where the text is not a number.
GIRTH_EXPORT std::optional<double> parseNumber(std::string_view text);

/// The shortest of 15, 16 or 17 significant digits that reads back as the same double. "nan", "inf"
/// and "-inf" for what is not finite.
GIRTH_EXPORT std::string formatNumber(double value);

/// The number for people: with six significant digits, all digits before the point, and never an
/// exponent. The page writes the same (tests/data/numbers.json).
GIRTH_EXPORT std::string readableNumber(double value);

}  // namespace girth::io
