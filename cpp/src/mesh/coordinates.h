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

/// Names the first vertex with a coordinate that is not a finite number (NON_FINITE_POSITION), or
/// of a size above kGreatestCoordinate (LIMIT_EXCEEDED).
inline std::optional<Error> findBadCoordinate(std::span<const double> positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (std::fabs(positions[i]) <= kGreatestCoordinate) continue;
    const auto vertex = static_cast<std::int64_t>(i / 3);
    const std::string name = "vertex " + std::to_string(vertex);
    if (!std::isfinite(positions[i])) {
      return makeError(ErrorCode::NonFinitePosition, vertex,
                       name + " has a coordinate that is not a finite number");
    }
    Error error =
        makeError(ErrorCode::LimitExceeded, vertex, name + " has a coordinate of more than 1e300");
    error.hint = "scale the model down: lengths of that size are no numbers";
    return error;
  }
  return std::nullopt;
}

}  // namespace girth
