// Lengths as they are typed: "3", "3mm".
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::cli {

/// A length in the model's unit: a number of at least 0, with or without a unit behind it (um, mm,
/// cm, m, km, in, ft). `modelUnit`: as in LoadedMesh; where it is empty,
/// because it is not known, the number can have no unit. Error: USAGE.
Result<double> lengthInModelUnit(const std::string& text, const std::string& modelUnit);

}  // namespace girth::cli
