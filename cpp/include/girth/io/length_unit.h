// Units of length by their names and symbols.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// A unit of length.
struct LengthUnit {
  std::string_view symbol;  ///< "mm"
  std::string_view name;    ///< "millimetre": what `ReadModel::unit` holds
  double metres;            ///< in one of it: 0.001
};

/// All of them (`length_units.def`), small ones first.
GIRTH_EXPORT std::span<const LengthUnit> lengthUnits();

/// Their symbols in words: "um, mm, cm, m, km, in or ft".
GIRTH_EXPORT std::string lengthUnitWords();

/// The unit with that name or symbol; null where there is none.
GIRTH_EXPORT const LengthUnit* findLengthUnit(std::string_view nameOrSymbol);

}  // namespace girth::io
