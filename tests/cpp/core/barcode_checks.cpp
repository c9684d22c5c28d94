#include "barcode_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "first_saddle.h"
#include "random_meshes.h"

namespace girth::test {

namespace {

bool near(double a, double b, double error) {
  return std::isinf(a) || std::isinf(b) ? a == b : std::fabs(a - b) <= error;
}

/// Whether all of `these` can be matched with some of `those`, no two with one (Kuhn's algorithm).
bool matched(const std::vector<Cycle>& these, const std::vector<Cycle>& those, double error,
             Cycle& without) {
  std::vector<std::size_t> owner(those.size(), those.size() + these.size());
  for (std::size_t i = 0; i < these.size(); ++i) {
    std::vector<bool> visited(those.size(), false);
    const std::function<bool(std::size_t)> assign = [&](std::size_t k) {
      for (std::size_t j = 0; j < those.size(); ++j) {
        if (visited[j] || !near(these[k].born, those[j].born, error) ||
            !near(these[k].filled, those[j].filled, error)) {
          continue;
        }
        visited[j] = true;
        if (owner[j] >= these.size() || assign(owner[j])) {
          owner[j] = k;
          return true;
        }
      }
      return false;
    };
    if (assign(i)) continue;
    without = these[i];
    return false;
  }
  return true;
}

std::string listed(const std::vector<Cycle>& cycles) {
  std::string text;
  for (const Cycle& cycle : cycles) {
    text += " " + std::to_string(cycle.born) + "-" + std::to_string(cycle.filled);
  }
  return text;
}

}  // namespace

int expectSampledBarcode(const SurfaceMesh& mesh, TextbookMmp& textbook, const SurfacePoint& point,
                         const Barcode& barcode, double spacing) {
  textbook.propagate(point);
  constexpr double kAll = std::numeric_limits<double>::max();
  const SampledCycles samples = sampledCycles(mesh, textbook, kAll, spacing);
  const double error = samples.error * (1 + 1e-6);
  std::vector<Cycle> all, bars, longSamples;
  for (const SaddleBar& bar : barcode.bars) {
    all.push_back({bar.birth, bar.death});
    if (bar.persistence() > 2 * error) bars.push_back(all.back());
  }
  for (const Cycle& cycle : samples.cycles) {
    if (cycle.filled - cycle.born > 2 * error) longSamples.push_back(cycle);
  }
  Cycle without{};
  EXPECT_TRUE(matched(bars, samples.cycles, error, without))
      << "no samples show bar " << listed({without}) << " of" << listed(all) << "\nsamples"
      << listed(longSamples) << " error " << error;
  EXPECT_TRUE(matched(longSamples, all, error, without))
      << "no bar for the samples' " << listed({without}) << ": bars" << listed(all) << "\nsamples"
      << listed(longSamples) << " error " << error;
  if (barcode.rest.kind == LoopKind::Antipodal) {
    EXPECT_NEAR(barcode.rest.length / 2, samples.farthest, error);
  }
  return static_cast<int>(bars.size());
}

int expectSampledBarcodes(std::uint64_t seed, Index vertices, double share) {
  const RandomMesh random = randomMesh(seed, 0.02);
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.history);
  const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
  const Index step = vertices == 0 ? 1 : 1 + (mesh.vertexCount() - 1) / vertices;
  return expectSampledBarcodes(mesh, static_cast<Index>(seed % step), step, share);
}

int expectSampledBarcodes(const SurfaceMesh& mesh, Index first, Index step, double share) {
  GirthSolver solver(mesh);
  TextbookMmp textbook(mesh);
  int seen = 0;
  for (Index v = first; v < mesh.vertexCount(); v += step) {
    SCOPED_TRACE("vertex " + std::to_string(v));
    const auto point = SurfacePoint::atVertex(Vertex(v));
    const auto barcode = solver.barcode(point, {});
    EXPECT_TRUE(barcode);
    if (!barcode) return seen;
    textbook.propagate(point);
    double farthest = 0;
    for (const Vertex w : mesh.vertices()) {
      const double distance = textbook.distanceTo(SurfacePoint::atVertex(w));
      if (std::isfinite(distance)) farthest = std::max(farthest, distance);
    }
    seen += expectSampledBarcode(mesh, textbook, point, barcode.value(), share * farthest);
  }
  return seen;
}

void expectPersistentGirths(std::uint64_t seed) {
  const RandomMesh random = randomMesh(seed, 0.02);
  const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
  GirthSolver whole(mesh), persistent(mesh);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", vertex " + std::to_string(v) + ": " +
                 random.history);
    const auto barcode = whole.barcode(Vertex(v), {});
    ASSERT_TRUE(barcode);
    const double girth = barcode.value().girth(0).length;
    std::vector<double> taus{1e-6 * girth, 0.02 * girth, 0.1 * girth, girth};
    for (std::size_t i = 0; i < std::min<std::size_t>(barcode.value().bars.size(), 3); ++i) {
      const double length = barcode.value().bars[i].persistence();
      if (!std::isfinite(length)) continue;
      taus.insert(taus.end(), {length * (1 - 1e-5), length * (1 + 1e-5)});
    }
    for (const double tau : taus) {
      persistent.setPersistence(tau);
      const auto value = persistent.value(Vertex(v));
      ASSERT_TRUE(value);
      EXPECT_EQ(value.value().length, barcode.value().girth(tau).length) << "tau " << tau;
      EXPECT_EQ(value.value().kind, barcode.value().girth(tau).kind) << "tau " << tau;
    }
  }
}

}  // namespace girth::test
