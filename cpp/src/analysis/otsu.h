// Dividing values in two.
#pragma once

#include <optional>
#include <vector>

namespace girth {

struct WeightedValue {
  double value, weight;
};

/// The value between two that divides them so that the sides differ most: the weighted variance
/// between the sides is greatest (Otsu 1979, on the values themselves instead of a histogram).
/// Nothing where it is no more than `least` of the whole variance. O(n log n).
std::optional<double> bestDivision(std::vector<WeightedValue> values, double least);

}  // namespace girth
