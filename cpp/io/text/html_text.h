// Text in HTML pages.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// Text with the signs of HTML replaced.
GIRTH_EXPORT std::string escapedHtml(std::string_view text);

/// A number with so many digits behind the point, which is a point in every locale.
GIRTH_EXPORT std::string decimalText(double value, int digits);

}  // namespace girth::io
