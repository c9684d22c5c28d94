#include "length_unit.h"

#include <array>
#include <utility>

namespace girth::io {

std::optional<double> metresIn(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{{
      {"metre", 1},
      {"centimetre", 0.01},
      {"millimetre", 0.001},
      {"micrometre", 1e-6},
      {"kilometre", 1000},
      {"inch", 0.0254},
      {"foot", 0.3048},
  }};
  for (const auto& [name, metres] : kUnits) {
    if (name == unit) return metres;
  }
  return std::nullopt;
}

}  // namespace girth::io
