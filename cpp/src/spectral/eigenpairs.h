// The lowest eigenpairs of one connected surface. Eigen and Spectra stop here.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "spectral/laplacian.h"

namespace girth::spectral {

struct Eigenpairs {
  /// Rising; the first is 0.
  std::vector<double> values;
  /// `vectors[k * n + v]`, orthonormal with respect to the areas. Their signs are arbitrary.
  std::vector<double> vectors;
};

/// The `count` lowest pairs of L φ = λ M φ, 1 ≤ count ≤ n, for a connected surface (spectrum.h
/// states how). Errors: CANCELLED, INTERNAL.
Result<Eigenpairs> lowestEigenpairs(const Laplacian& laplacian, Index count,
                                    const ExecutionContext& context);

}  // namespace girth::spectral
