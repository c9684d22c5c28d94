#include "girth/heat_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/angles.h"
#include "spectral/squared_sums.h"

namespace girth {

namespace {

constexpr double kMostTimes = 100'000;

Error optionError(std::string message) {
  return makeError(ErrorCode::InvalidOption, -1, std::move(message));
}

VertexSignatures heatAt(const Spectrum& spectrum, std::span<const double> times,
                        std::size_t pairs) {
  std::vector<double> weights;
  weights.reserve(pairs * times.size());
  for (std::size_t k = 0; k < pairs; ++k) {
    for (const double time : times) weights.push_back(std::exp(-spectrum.values[k] * time));
  }
  return spectral::squaredSums(spectrum, times.size(), weights);
}

}  // namespace

Result<VertexSignatures> heatKernelSignature(const Spectrum& spectrum,
                                             std::span<const double> times) {
  if (auto error = spectral::checkSpectrum(spectrum)) return *std::move(error);
  if (times.empty()) return optionError("no times; at least one");
  for (const double time : times) {
    if (!(time >= 0 && std::isfinite(time))) {
      return optionError("a diffusion time is negative or no number");
    }
  }
  return heatAt(spectrum, times, spectrum.values.size());
}

Result<VertexSignatures> scaleInvariantHeatKernelSignature(const Spectrum& spectrum,
                                                           const SihksOptions& options) {
  if (auto error = spectral::checkSpectrum(spectrum)) return *std::move(error);
  const double steps = std::floor((options.last - options.first) / options.step + 1e-9);
  if (!(options.step > 0 && steps >= 1 && steps < kMostTimes)) {
    return optionError("the times are to run from the first to the last by steps above 0, 2 to " +
                       std::to_string(static_cast<int>(kMostTimes)) + " of them");
  }
  const double area = std::accumulate(spectrum.areas.begin(), spectrum.areas.end(), 0.0);
  std::vector<double> times;
  for (double i = 0; i <= steps; ++i) {
    times.push_back(std::pow(options.base, options.first + i * options.step) *
                    (area / options.referenceArea));
  }
  if (!(options.base > 1 && options.referenceArea > 0 && std::isfinite(times.back()))) {
    return optionError("the base is to be above 1, the reference area above 0, both finite");
  }
  const std::size_t count = times.size() - 1;
  const std::size_t kept = options.frequencies;
  if (kept == 0 || options.lowestFrequency + kept > count) {
    return optionError("of " + std::to_string(count) + " differences there are frequencies 0 to " +
                       std::to_string(count - 1));
  }
  const std::size_t all = spectrum.values.size();
  const VertexSignatures heat = heatAt(
      spectrum, times,
      options.eigenfunctions == 0 ? all : std::min<std::size_t>(all, options.eigenfunctions));

  std::vector<double> cosines(count * kept), sines(count * kept);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t f = 0; f < kept; ++f) {
      // Reduced to one turn in whole numbers, where nothing is lost.
      const std::size_t turn = i * (options.lowestFrequency + f) % count;
      const double angle = 2 * kPi * static_cast<double>(turn) / static_cast<double>(count);
      cosines[i * kept + f] = std::cos(angle);
      sines[i * kept + f] = std::sin(angle);
    }
  }
  VertexSignatures result;
  result.dimensions = kept;
  result.values.reserve(spectrum.areas.size() * kept);
  std::vector<double> real(kept), imaginary(kept);
  for (std::size_t v = 0; v < spectrum.areas.size(); ++v) {
    std::fill(real.begin(), real.end(), 0.0);
    std::fill(imaginary.begin(), imaginary.end(), 0.0);
    const double* values = &heat.values[v * times.size()];
    double last = std::log(values[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const double next = std::log(values[i + 1]), difference = next - last;
      last = next;
      for (std::size_t f = 0; f < kept; ++f) {
        real[f] += difference * cosines[i * kept + f];
        imaginary[f] += difference * sines[i * kept + f];
      }
    }
    for (std::size_t f = 0; f < kept; ++f) {
      result.values.push_back(std::sqrt(real[f] * real[f] + imaginary[f] * imaginary[f]));
    }
  }
  return result;
}

}  // namespace girth
