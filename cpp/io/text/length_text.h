// Lengths as people type them: "3", "28 mm", "1.1in". The page reads them in the same way
// (web/src/view/length-text.ts); tests/data/lengths.json holds both to it.
#pragma once

#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/length_unit.h"

namespace girth::io {

/// A typed length: a number of at least 0, and the unit behind it.
struct TypedLength {
  double number{0};
  const LengthUnit* unit{nullptr};  ///< null where none was typed
};

/// Reads a number with or without a unit behind it (a symbol or a name), spaces
/// around both; a comma may stand for the point. Error: USAGE.
GIRTH_EXPORT Result<TypedLength> parseLength(std::string_view text);

/// A typed length in the unit `unit` (a symbol or a name); a bare number is in that unit already.
/// Where `unit` is empty, because it is not known, none can be typed. Error: USAGE.
GIRTH_EXPORT Result<double> lengthInUnit(std::string_view text, std::string_view unit);

/// A length, or a share of `whole`, a length in that unit: "2%" is 0.02 times as long. Error:
/// USAGE.
GIRTH_EXPORT Result<double> lengthOrShare(std::string_view text, std::string_view unit,
                                          double whole);

}  // namespace girth::io
