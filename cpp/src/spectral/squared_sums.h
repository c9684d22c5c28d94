// Sums of squared eigenfunctions, which all spectral signatures are made of.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "girth/error.h"
#include "girth/spectrum.h"
#include "girth/vertex_signatures.h"

namespace girth::spectral {

/// The fault of a spectrum: USAGE where its arrays do not belong together.
std::optional<Error> checkSpectrum(const Spectrum& spectrum);

/// Σ_k weights[k · dimensions + d] φ_k(v)² for every vertex and dimension, over as many pairs as
/// there are weights for.
VertexSignatures squaredSums(const Spectrum& spectrum, std::size_t dimensions,
                             const std::vector<double>& weights);

}  // namespace girth::spectral
