// Maxima and their persistence: by hand, by the definition on random fields, and of heat.
#include "girth/persistent_maxima.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>

#include "corpus.h"
#include "girth/geodesic_extent.h"
#include "girth/heat_maxima.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Shape;

const double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<PersistentMaximum> maximaOf(const SurfaceMesh& mesh,
                                        const std::vector<double>& values) {
  auto maxima = persistentMaxima(mesh, values);
  EXPECT_TRUE(maxima.ok());
  return maxima.ok() ? std::move(maxima).value() : std::vector<PersistentMaximum>{};
}

/// Vertices numbered along a strip: each has the next as a neighbour, and the one after it.
SurfaceMesh strip(Index vertices) {
  Shape shape;
  for (Index v = 0; v < vertices; ++v) shape.add(v, v % 2, 0);
  for (Index v = 0; v + 2 < vertices; ++v) {
    v % 2 == 0 ? shape.face(v, v + 2, v + 1) : shape.face(v, v + 1, v + 2);
  }
  return shape.mesh(OpenEdges::Boundary);
}

TEST(PersistentMaxima, ByHand) {
  //                       0  1  2  3  4  5  6  7  8  9
  const std::vector<double> values{5, 2, 2, 9, 4, 3, 7, 1, 1, 8};
  // The ways to higher ones lead from 9 down to 1, from 6 by vertex 4, from 0 down to 2.
  const auto maxima = maximaOf(strip(10), values);
  ASSERT_EQ(maxima.size(), 4u);
  const Index vertices[] = {3, 9, 6, 0};
  const double persistence[] = {8, 7, 3, 3};
  const Index saddles[] = {kNoIndex, 7, 4, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(maxima[i].vertex, vertices[i]);
    EXPECT_EQ(maxima[i].value, values[vertices[i]]);
    EXPECT_EQ(maxima[i].persistence, persistence[i]) << "vertex " << vertices[i];
    EXPECT_EQ(maxima[i].saddle, saddles[i]) << "vertex " << vertices[i];
  }
}

TEST(PersistentMaxima, OfConstantAndMissingValues) {
  const auto flat = maximaOf(strip(6), std::vector<double>(6, 3.0));
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_EQ(flat[0].vertex, 0u);
  EXPECT_EQ(flat[0].persistence, 0);
  // Two vertices without a value cut the strip.
  const auto cut = maximaOf(strip(6), {1, 2, kNaN, kNaN, 5, 4});
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_EQ(cut[0].saddle, kNoIndex);
  EXPECT_EQ(cut[1].saddle, kNoIndex);
  EXPECT_TRUE(maximaOf(strip(6), std::vector<double>(6, kNaN)).empty());
  const auto wrong = persistentMaxima(strip(6), std::vector<double>(5, 1.0));
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().code, ErrorCode::Usage);
}

/// The highest pass between a vertex and any higher one; minus infinity where there is none.
double highestPass(const SurfaceMesh& mesh, const std::vector<double>& values, Index start) {
  std::priority_queue<std::pair<double, Index>> queue;
  std::vector<bool> seen(mesh.vertexCount(), false);
  queue.push({values[start], start});
  while (!queue.empty()) {
    const auto [pass, v] = queue.top();
    queue.pop();
    if (seen[v]) continue;
    seen[v] = true;
    if (values[v] > values[start]) return pass;
    for (const Halfedge h : mesh.halfedges()) {
      const Vertex other = mesh.from(h) == v ? mesh.to(h)
                           : mesh.to(h) == v ? mesh.from(h)
                                             : Vertex(v);
      if (!seen[other]) queue.push({std::min(pass, values[other]), other});
    }
  }
  return -std::numeric_limits<double>::infinity();
}

TEST(PersistentMaxima, AreWhatTheDefinitionSays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const test::RandomMesh random = test::randomMesh(seed);
    SCOPED_TRACE(random.history);
    const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
    test::Random number(seed);
    std::vector<double> values;
    for (Index v = 0; v < mesh.vertexCount(); ++v) values.push_back(number());
    const double least = *std::min_element(values.begin(), values.end());
    std::set<Index> expected;
    for (const Vertex v : mesh.vertices()) {
      if (highestPass(mesh, values, v) < values[v]) expected.insert(v);
    }
    double last = std::numeric_limits<double>::infinity();
    for (const PersistentMaximum& maximum : maximaOf(mesh, values)) {
      EXPECT_EQ(expected.erase(maximum.vertex), 1u);
      EXPECT_LE(maximum.persistence, last);
      last = maximum.persistence;
      const double pass = highestPass(mesh, values, maximum.vertex);
      const double lowest = std::isinf(pass) ? least : pass;
      EXPECT_EQ(maximum.persistence, maximum.value - lowest);
      EXPECT_EQ(maximum.saddle == kNoIndex ? least : values[maximum.saddle], lowest);
    }
    EXPECT_TRUE(expected.empty());
  }
}

TEST(HeatMaxima, OfABoxAreItsCorners) {
  const SurfaceMesh mesh = test::box(3, 2, 1, 24, 16, 8).mesh();
  const auto spectrum = laplaceSpectrum(mesh);
  ASSERT_TRUE(spectrum.ok());
  const auto maxima = persistentHeatMaxima(mesh, spectrum.value());
  ASSERT_TRUE(maxima.ok());
  ASSERT_GE(maxima.value().size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3& p = mesh.position(Vertex(maxima.value()[i].vertex));
    EXPECT_TRUE((p.x == 0 || p.x == 3) && (p.y == 0 || p.y == 2) && (p.z == 0 || p.z == 1)) << i;
  }
  if (maxima.value().size() > 8) {
    EXPECT_LT(maxima.value()[8].persistence, 0.1 * maxima.value()[7].persistence);
  }
  EXPECT_FALSE(persistentHeatMaxima(mesh, spectrum.value(), -1).ok());
}

TEST(PersistentMaxima, OfGeoAverageAreTheEndsOfARod) {
  const SurfaceMesh mesh = test::box(6, 1, 1, 30, 5, 5).mesh();
  const auto extent = geodesicExtent(mesh, DistanceMethod::FastMarching);
  for (const std::vector<double>* field : {&extent.average, &extent.farthest}) {
    const auto maxima = maximaOf(mesh, *field);
    ASSERT_GE(maxima.size(), 2u);
    EXPECT_NEAR(std::fabs(mesh.position(Vertex(maxima[0].vertex)).x -
                          mesh.position(Vertex(maxima[1].vertex)).x),
                6, 1e-9);
    EXPECT_GT(maxima[1].persistence, 0.9 * maxima[0].persistence);
    const double third = maxima.size() > 2 ? maxima[2].persistence : 0;
    EXPECT_LT(third, 0.2 * maxima[1].persistence);
  }
}

TEST(HeatMaxima, FindTheArmsOfAnOctopus) {
  if (!test::corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  const SurfaceMesh mesh = test::corpusModel("octopus_14256f.off");
  const auto spectrum = laplaceSpectrum(mesh, {100});
  ASSERT_TRUE(spectrum.ok());
  const auto heat = persistentHeatMaxima(mesh, spectrum.value(), 4e-3);
  ASSERT_TRUE(heat.ok());
  ASSERT_GT(heat.value().size(), 8u);
  EXPECT_LT(heat.value()[8].persistence, 0.2 * heat.value()[7].persistence);
}

}  // namespace
}  // namespace girth
