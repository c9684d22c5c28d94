#include "girth/io/length_unit.h"

#include <array>

namespace girth::io {
namespace {

constexpr std::array kUnits{
#define GIRTH_LENGTH_UNIT(symbol, name, metres) LengthUnit{symbol, name, metres},
#include "girth/io/length_units.def"
};

}  // namespace

std::span<const LengthUnit> lengthUnits() { return kUnits; }

std::string lengthUnitWords() {
  std::string words(kUnits.front().symbol);
  for (std::size_t i = 1; i < kUnits.size(); ++i) {
    words += i + 1 < kUnits.size() ? ", " : " or ";
    words += kUnits[i].symbol;
  }
  return words;
}

const LengthUnit* findLengthUnit(std::string_view nameOrSymbol) {
  for (const LengthUnit& unit : kUnits) {
    if (unit.name == nameOrSymbol || unit.symbol == nameOrSymbol) return &unit;
  }
  return nullptr;
}

}  // namespace girth::io
