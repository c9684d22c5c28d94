#include "spectral/squared_sums.h"

#include <string>

namespace girth::spectral {

std::optional<Error> checkSpectrum(const Spectrum& spectrum) {
  const std::size_t pairs = spectrum.values.size(), vertices = spectrum.areas.size();
  if (pairs > 0 && vertices > 0 && spectrum.vectors.size() == pairs * vertices) {
    return std::nullopt;
  }
  return makeError(ErrorCode::Usage, -1,
                   "a spectrum of " + std::to_string(pairs) + " values for " +
                       std::to_string(vertices) + " vertices has " +
                       std::to_string(spectrum.vectors.size()) + " numbers in its functions");
}

VertexSignatures squaredSums(const Spectrum& spectrum, std::size_t dimensions,
                             const std::vector<double>& weights) {
  const std::size_t n = spectrum.areas.size(), pairs = weights.size() / dimensions;
  VertexSignatures sums;
  sums.dimensions = dimensions;
  sums.values.assign(n * dimensions, 0);
  for (std::size_t k = 0; k < pairs; ++k) {
    const double* weight = &weights[k * dimensions];
    for (std::size_t v = 0; v < n; ++v) {
      const double phi = spectrum.vectors[k * n + v], square = phi * phi;
      double* sum = &sums.values[v * dimensions];
      for (std::size_t d = 0; d < dimensions; ++d) sum[d] += weight[d] * square;
    }
  }
  return sums;
}

}  // namespace girth::spectral
