// Heat and wave kernel signatures: closed forms, invariance, and bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "girth/heat_kernel.h"
#include "girth/wave_kernel.h"
#include "mesh/angles.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Shape;

Spectrum pairsOf(const SurfaceMesh& mesh, Index pairs) {
  auto spectrum = laplaceSpectrum(mesh, {pairs});
  EXPECT_TRUE(spectrum.ok());
  return spectrum.ok() ? std::move(spectrum).value() : Spectrum{};
}

Shape bumpy() { return test::perturbed(test::torus(3, 1, 30, 15), 0.2, 9); }

/// Two vertices and two functions, by hand: values 0 and 3, areas ½ and 1½.
Spectrum smallSpectrum() {
  const double a = 1 / std::sqrt(2.0);
  return {{0, 3}, {a, a, std::sqrt(1.5), -std::sqrt(1.0 / 6)}, {0.5, 1.5}};
}

TEST(HeatKernel, ByHand) {
  const double times[] = {0, 0.5, 100};
  const auto heat = heatKernelSignature(smallSpectrum(), times);
  ASSERT_TRUE(heat.ok());
  EXPECT_EQ(heat.value().dimensions, 3u);
  const std::vector<double>& values = heat.value().values;
  ASSERT_EQ(values.size(), 6u);
  // At the time 0: 1 / area.
  EXPECT_NEAR(values[0], 2, 1e-12);
  EXPECT_NEAR(values[3], 2.0 / 3, 1e-12);
  EXPECT_NEAR(values[1], 0.5 + 1.5 * std::exp(-1.5), 1e-12);
  EXPECT_NEAR(values[4], 0.5 + std::exp(-1.5) / 6, 1e-12);
  EXPECT_NEAR(values[2], 0.5, 1e-12);
  EXPECT_NEAR(values[5], 0.5, 1e-12);
}

TEST(HeatKernel, OfASphere) {
  // Σ (2 l + 1) exp(−l (l + 1) t) / 4π everywhere.
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const Spectrum spectrum = pairsOf(mesh, 144);
  const double times[] = {0.1, 0.5, 2};
  const auto heat = heatKernelSignature(spectrum, times);
  ASSERT_TRUE(heat.ok());
  for (std::size_t d = 0; d < 3; ++d) {
    double expected = 0;
    for (int l = 0; l < 12; ++l) {
      expected += (2 * l + 1) * std::exp(-l * (l + 1) * times[d]) / (4 * kPi);
    }
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      ASSERT_NEAR(heat.value().values[3 * v + d], expected, 0.02 * expected);
    }
  }
}

TEST(HeatKernel, ItsIntegralIsTheSumOverTheValues) {
  const SurfaceMesh mesh = bumpy().mesh();
  const Spectrum spectrum = pairsOf(mesh, 50);
  const double times[] = {0.3};
  const auto heat = heatKernelSignature(spectrum, times);
  ASSERT_TRUE(heat.ok());
  double trace = 0, sum = 0;
  for (const double value : spectrum.values) trace += std::exp(-0.3 * value);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    sum += spectrum.areas[v] * heat.value().values[v];
  }
  EXPECT_NEAR(sum, trace, 1e-9 * trace);
}

TEST(HeatKernel, ScaleInvariantMeansSo) {
  const Shape shape = bumpy();
  const auto one = scaleInvariantHeatKernelSignature(pairsOf(shape.mesh(), 60));
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one.value().dimensions, 19u);
  double greatest = 0;
  for (const double value : one.value().values) {
    ASSERT_TRUE(std::isfinite(value));
    greatest = std::max(greatest, value);
  }
  EXPECT_GT(greatest, 0.1);
  for (const double scale : {1e-100, 3.0, 1e100}) {
    const auto scaled =
        scaleInvariantHeatKernelSignature(pairsOf(test::moved(shape, scale, 0, 0).mesh(), 60));
    ASSERT_TRUE(scaled.ok());
    for (std::size_t i = 0; i < one.value().values.size(); ++i) {
      ASSERT_NEAR(scaled.value().values[i], one.value().values[i], 1e-7 * greatest);
    }
  }
}

TEST(HeatKernel, TheTransformIsThatOfTheDifferences) {
  // By the definition, for one vertex and one frequency.
  const Spectrum spectrum = smallSpectrum();
  SihksOptions options;
  options.base = 3;
  options.first = -2;
  options.last = 2;
  options.step = 0.5;
  options.frequencies = 3;
  options.lowestFrequency = 0;
  options.referenceArea = 2;  // the area itself
  const auto result = scaleInvariantHeatKernelSignature(spectrum, options);
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result.value().values.size(), 6u);
  const auto logAt = [](double tau) {
    return std::log(0.5 + 1.5 * std::exp(-3 * std::pow(3.0, tau)));
  };
  for (int f = 0; f < 3; ++f) {
    double re = 0, im = 0;
    for (int i = 0; i < 8; ++i) {
      const double difference = logAt(-2 + 0.5 * (i + 1)) - logAt(-2 + 0.5 * i);
      re += difference * std::cos(2 * kPi * i * f / 8);
      im -= difference * std::sin(2 * kPi * i * f / 8);
    }
    EXPECT_NEAR(result.value().values[static_cast<std::size_t>(f)], std::hypot(re, im), 1e-12);
  }
  // With the constant function alone the heat stays where it is.
  options.eigenfunctions = 1;
  const auto constant = scaleInvariantHeatKernelSignature(spectrum, options);
  ASSERT_TRUE(constant.ok());
  for (const double value : constant.value().values) EXPECT_EQ(value, 0);
}

TEST(WaveKernel, WeighsTheFunctionsByTheirEnergy) {
  // Three functions; narrow energies see one at a time.
  Spectrum spectrum = smallSpectrum();
  spectrum.values.push_back(3 * std::exp(1.02));
  spectrum.vectors.insert(spectrum.vectors.end(), {0.1, 0.2});
  const auto narrow = waveKernelSignature(spectrum, {11, 1e-3});
  ASSERT_TRUE(narrow.ok());
  EXPECT_EQ(narrow.value().dimensions, 11u);
  for (std::size_t d = 0; d < 11; ++d) {
    EXPECT_NEAR(narrow.value().values[d], d <= 5 ? 1.5 : 0.01, 1e-12) << d;
  }
  const auto wide = waveKernelSignature(spectrum, {2, 1});
  ASSERT_TRUE(wide.ok());
  // Energies log 3 and log 3 + 1, width 1.
  const double g = std::exp(-1.02 * 1.02 / 2), h = std::exp(-0.5), i = std::exp(-0.02 * 0.02 / 2);
  EXPECT_NEAR(wide.value().values[0], (1.5 + g * 0.01) / (1 + g), 1e-12);
  EXPECT_NEAR(wide.value().values[1], (h * 1.5 + i * 0.01) / (h + i), 1e-12);
}

TEST(WaveKernel, ShrinksWithTheAreaAndHasItsMean) {
  const Shape shape = bumpy();
  const SurfaceMesh mesh = shape.mesh();
  const Spectrum spectrum = pairsOf(mesh, 60);
  const auto one = waveKernelSignature(spectrum);
  const auto scaled = waveKernelSignature(pairsOf(test::moved(shape, 1e50, 0, 0).mesh(), 60));
  ASSERT_TRUE(one.ok() && scaled.ok());
  ASSERT_EQ(one.value().dimensions, 100u);
  for (std::size_t i = 0; i < one.value().values.size(); ++i) {
    ASSERT_NEAR(scaled.value().values[i] * 1e50 * 1e50, one.value().values[i],
                1e-6 * one.value().values[i]);
  }
  for (const std::size_t d : {0u, 50u, 99u}) {
    double mean = 0;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      mean += spectrum.areas[v] * one.value().values[100 * v + d];
    }
    EXPECT_NEAR(mean, 1, 1e-9);
  }
}

TEST(SpectralSignatures, RefuseWhatMakesNoSense) {
  const Spectrum spectrum = smallSpectrum();
  const auto codeOf = [](const auto& result) {
    return result.ok() ? ErrorCode::Internal : result.error().code;
  };
  const double bad[] = {1, -1}, worse[] = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(codeOf(heatKernelSignature(spectrum, {})), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(heatKernelSignature(spectrum, bad)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(heatKernelSignature(spectrum, worse)), ErrorCode::InvalidOption);
  Spectrum broken = spectrum;
  broken.vectors.pop_back();
  const double time[] = {1};
  EXPECT_EQ(codeOf(heatKernelSignature(broken, time)), ErrorCode::Usage);
  EXPECT_EQ(codeOf(scaleInvariantHeatKernelSignature(broken)), ErrorCode::Usage);
  EXPECT_EQ(codeOf(waveKernelSignature(broken)), ErrorCode::Usage);
  EXPECT_EQ(codeOf(waveKernelSignature({})), ErrorCode::Usage);
  EXPECT_EQ(codeOf(waveKernelSignature(spectrum)), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(waveKernelSignature(spectrum, {1, 6})), ErrorCode::InvalidOption);
  EXPECT_EQ(codeOf(waveKernelSignature(spectrum, {100, 0})), ErrorCode::InvalidOption);
  const auto sihks = [&](auto change) {
    SihksOptions options;
    change(options);
    return codeOf(scaleInvariantHeatKernelSignature(spectrum, options));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sihks([](SihksOptions&) {}), ErrorCode::Internal);  // fine: no error
  EXPECT_EQ(sihks([](SihksOptions& o) { o.base = 1; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.step = 0; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.last = 1; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.step = 1e-9; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([&](SihksOptions& o) { o.first = nan; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([&](SihksOptions& o) { o.referenceArea = nan; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.last = 1e4; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.frequencies = 0; }), ErrorCode::InvalidOption);
  EXPECT_EQ(sihks([](SihksOptions& o) { o.frequencies = 95; }), ErrorCode::InvalidOption);
}

}  // namespace
}  // namespace girth
