#include "girth/wave_kernel.h"

#include <algorithm>
#include <cmath>

#include "spectral/squared_sums.h"

namespace girth {

namespace {

constexpr Index kMostEnergies = 100'000;
/// Values nearer to each other than this share are the same but for rounding.
constexpr double kSame = 1e-9;

}  // namespace

Result<VertexSignatures> waveKernelSignature(const Spectrum& spectrum, const WksOptions& options) {
  if (auto error = spectral::checkSpectrum(spectrum)) return *std::move(error);
  const auto optionError = [](std::string message) {
    return makeError(ErrorCode::InvalidOption, -1, std::move(message));
  };
  if (options.energies < 2 || options.energies > kMostEnergies) {
    return optionError(std::to_string(options.energies) + " energies; 2 to " +
                       std::to_string(kMostEnergies));
  }
  if (!(options.variance > 0 && std::isfinite(options.variance))) {
    return optionError("the width of the energies is to be a number above 0");
  }
  std::vector<double> logs;
  for (const double value : spectrum.values) {
    if (value > 0) logs.push_back(std::log(value));
  }
  if (logs.empty() || !(logs.back() - logs.front() > kSame)) {
    return optionError("the spectrum has no two different values above 0: compute more pairs");
  }
  const std::size_t zeros = spectrum.values.size() - logs.size(), energies = options.energies;
  const double step =
      (logs.back() - logs.front()) / 1.02 / static_cast<double>(options.energies - 1);
  const double sigma = options.variance * step;
  std::vector<double> weights(spectrum.values.size() * energies, 0);
  for (std::size_t d = 0; d < energies; ++d) {
    const double energy = logs.front() + static_cast<double>(d) * step;
    const auto exponent = [&](double log) {
      const double x = (energy - log) / sigma;
      return -x * x / 2;
    };
    // Relative to the greatest, so that narrow distributions do not vanish between two values.
    double greatest = exponent(logs.front()), sum = 0;
    for (const double log : logs) greatest = std::max(greatest, exponent(log));
    for (std::size_t k = 0; k < logs.size(); ++k) {
      const double weight = std::exp(exponent(logs[k]) - greatest);
      weights[(zeros + k) * energies + d] = weight;
      sum += weight;
    }
    for (std::size_t k = zeros; k < spectrum.values.size(); ++k) {
      weights[k * energies + d] /= sum;
    }
  }
  return spectral::squaredSums(spectrum, energies, weights);
}

}  // namespace girth
