// Text in HTML pages.
#pragma once

#include <string>
#include <string_view>

namespace girth::io {

/// Text with the signs of HTML replaced.
std::string escapedHtml(std::string_view text);

/// A number with so many digits behind the point, which is a point in every locale.
std::string decimalText(double value, int digits);

}  // namespace girth::io
