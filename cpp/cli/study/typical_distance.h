// Typical distances: between poses of one shape, and between shapes of different classes.
#pragma once

#include <optional>
#include <string>

#include "study/comparison.h"

namespace girth::cli {

/// Medians over a collection (web/docs/choosing.md).
struct TypicalDistance {
  double poses;    ///< between two poses of one shape
  double classes;  ///< between two shapes of different classes
};

/// The typical distance of a descriptor, as measured on models scaled to area 1, by the exact
/// distance of their distributions. Nothing where it was not measured, or is computed otherwise.
std::optional<TypicalDistance> typicalDistance(const std::string& descriptor,
                                               const ComparisonOptions& options);

}  // namespace girth::cli
