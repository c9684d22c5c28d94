// The unit of a model in formats that have no place for it: as it is written, and read again.
#pragma once

#include <string>
#include <string_view>

namespace girth::io {

/// A line of comment, as in "# unit: millimetre"; nothing where the unit is not known. `mark`: how
/// comments begin.
std::string unitComment(std::string_view mark, std::string_view unit);

/// The unit of the first such line near the beginning of a text, by its name; it may be written as
/// a symbol. Empty where there is none that is known.
std::string unitInComments(std::string_view text, std::string_view mark);

/// The beginning of the header of a binary STL: "binary STL, unit: millimetre".
std::string unitHeader(std::string_view unit);

/// The unit of such a header, by its name. Empty where there is none that is known.
std::string unitInHeader(std::string_view header);

}  // namespace girth::io
