#include "girth/io/length_unit.h"

#include <array>

namespace girth::io {
namespace {

constexpr std::array<LengthUnit, 7> kUnits{{{"um", "micrometre", 1e-6},
                                            {"mm", "millimetre", 1e-3},
                                            {"cm", "centimetre", 1e-2},
                                            {"m", "metre", 1},
                                            {"km", "kilometre", 1e3},
                                            {"in", "inch", 0.0254},
                                            {"ft", "foot", 0.3048}}};

}  // namespace

std::span<const LengthUnit> lengthUnits() { return kUnits; }

const LengthUnit* findLengthUnit(std::string_view nameOrSymbol) {
  for (const LengthUnit& unit : kUnits) {
    if (unit.name == nameOrSymbol || unit.symbol == nameOrSymbol) return &unit;
  }
  return nullptr;
}

}  // namespace girth::io
