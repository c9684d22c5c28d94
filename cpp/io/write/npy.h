// Arrays of doubles as NumPy reads them.
#pragma once

#include <string>
#include <string_view>

namespace girth::io {

/// The header that stands before the doubles, which follow in the order of C: format version 1.0,
/// dtype '<f8'. `shape`: as Python has it between the parentheses, "5," or "5, 3".
std::string npyHeader(std::string_view shape);

}  // namespace girth::io
