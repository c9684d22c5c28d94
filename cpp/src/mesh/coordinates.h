// Which coordinates are computed with.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "girth/error.h"

namespace girth {

/// The greatest size of a coordinate, in model units: lengths of this order are finite, and
/// so are the sums of a million of them.
constexpr double kGreatestCoordinate = 1e300;

/// The error of a vertex with a coordinate that is not a finite number (NON_FINITE_POSITION), or of
/// a size above kGreatestCoordinate (LIMIT_EXCEEDED). `where`: what follows its name, " of face 3".
inline std::optional<Error> badCoordinateOf(std::size_t vertex, std::span<const double> positions,
                                            const std::string& where = {}) {
  for (const double coordinate : positions.subspan(3 * vertex, 3)) {
    if (std::fabs(coordinate) <= kGreatestCoordinate) continue;
    const auto element = static_cast<std::int64_t>(vertex);
    const std::string name = "vertex " + std::to_string(vertex) + where;
    if (!std::isfinite(coordinate)) {
      return makeError(ErrorCode::NonFinitePosition, element,
                       name + " has a coordinate that is not a finite number");
    }
    Error error =
        makeError(ErrorCode::LimitExceeded, element, name + " has a coordinate of more than 1e300");
    error.hint = "scale the model down: lengths of that size are no numbers";
    return error;
  }
  return std::nullopt;
}

}  // namespace girth
