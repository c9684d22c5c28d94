// Lengths as a user types them: "3", "3mm".
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::cli {

/// A length in the model's unit: a number of at least 0, with or without a unit behind it (um, mm,
/// cm, m, km, in, ft). `modelUnit`: as of LoadedMesh; empty where nobody knows it, and then there
/// can be no unit behind the number. Error: USAGE.
Result<double> lengthInModelUnit(const std::string& text, const std::string& modelUnit);

}  // namespace girth::cli
