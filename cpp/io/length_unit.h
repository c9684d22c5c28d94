// Units of length by their names.
#pragma once

#include <optional>
#include <string_view>

namespace girth::io {

/// How many metres a unit is ("metre", "centimetre", "millimetre", "micrometre", "kilometre",
/// "inch", "foot"); nothing where the name is none of these.
std::optional<double> metresIn(std::string_view unit);

}  // namespace girth::io
