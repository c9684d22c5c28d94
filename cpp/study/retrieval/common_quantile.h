// A bound that many distributions have in common, and what happens to values beyond it.
#pragma once

#include <span>

#include "girth/distribution.h"

namespace girth::study {

/// The least value that at least `share` (in (0, 1]) of all distributions taken together does not
/// exceed; each of them counts alike, empty ones not. NaN where all are empty. O(n log n).
double commonQuantile(std::span<const Distribution> distributions, double share);

/// Greater values count as `greatest`. O(n).
void capValues(Distribution& distribution, double greatest);

}  // namespace girth::study
