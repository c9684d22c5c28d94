// Weighted distributions of numbers, and how far two of them are apart.
#pragma once

#include <span>
#include <vector>

#include "girth/export.h"

namespace girth {

/// How much of a whole has which value: the cumulative distribution is a flight of stairs that
/// rises by shares[i] at values[i].
struct Distribution {
  /// Rising; equal values may stand beside each other.
  std::vector<double> values;
  /// They add up to 1.
  std::vector<double> shares;

  /// Whether nothing counts.
  bool empty() const { return values.empty(); }
};

/// The distribution of `values`, each counted by its weight (in the core: the vertex's area).
/// Values that are not finite do not count; without any others, or without any weight, the
/// distribution is empty. It does not depend on the order of the vertices. O(n log n).
GIRTH_EXPORT Distribution distributionOf(std::span<const double> values,
                                         std::span<const double> weights);

/// The earth mover's distance of two distributions with |x − y| as the cost, which on the line is
/// the integral of |CDF1 − CDF2| (equation (1) of the paper; section 6.1): exact, in the unit of
/// the values. NaN where one is empty. O(n + m).
GIRTH_EXPORT double earthMoversDistance(const Distribution& one, const Distribution& two);

}  // namespace girth
