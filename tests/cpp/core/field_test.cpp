// All vertices at once: threads, order, progress, partial results, cancelling.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "girth/girth_field.h"
#include "girth/study/naive_girth.h"
#include "mesh/vector.h"
#include "shapes.h"

namespace girth::test {
namespace {

TEST(Field, GivesTheSameBitsOnAnyNumberOfThreads) {
  const SurfaceMesh mesh = perturbed(plate(2), 0.1, 1).mesh();
  GirthSolver solver(mesh);
  for (const unsigned threads : {1u, 2u, 5u}) {
    ExecutionContext context;
    context.threads = threads;
    const GirthField field = girthField(mesh, GirthMethod::Exact, context);
    ASSERT_TRUE(field.complete());
    EXPECT_GT(field.statistics.windowsCreated, 0u);
    for (const Vertex v : mesh.vertices()) {
      const GirthValue alone = solver.value(v).value();
      EXPECT_EQ(field.values[v], alone.length);
      EXPECT_EQ(field.kinds[v], alone.kind);
    }
  }
}

TEST(Field, NaiveAgreesWithExact) {
  const SurfaceMesh mesh = perturbed(torus(2, 0.7, 9, 5), 0.1, 1).mesh();
  const GirthField exact = girthField(mesh), naive = study::naiveGirthField(mesh);
  for (const Vertex v : mesh.vertices()) {
    EXPECT_NEAR(exact.values[v] / naive.values[v], 1, 1e-9);
    EXPECT_EQ(exact.kinds[v], naive.kinds[v]);
  }
}

TEST(Field, ReportsEveryVertexOnceAndProgressNeverFalls) {
  const SurfaceMesh mesh = perturbed(octasphere(3), 0.1, 1).mesh();
  for (const unsigned threads : {1u, 2u}) {
    ExecutionContext context;
    context.threads = threads;
    double last = 0;
    context.onProgress = [&](double fraction) {
      EXPECT_GT(fraction, last);
      last = fraction;
    };
    std::vector<int> seen(mesh.vertexCount(), 0);
    std::vector<double> values(mesh.vertexCount());
    const GirthField field =
        girthField(mesh, GirthMethod::Exact, context, [&](const GirthPartial& partial) {
          ASSERT_EQ(partial.vertices.size(), partial.values.size());
          for (std::size_t i = 0; i < partial.vertices.size(); ++i) {
            ++seen[partial.vertices[i]];
            values[partial.vertices[i]] = partial.values[i].length;
          }
        });
    EXPECT_EQ(last, 1);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
    EXPECT_EQ(values, field.values);
  }
}

TEST(Field, StopsWhenTold) {
  const SurfaceMesh mesh = octasphere(5).mesh();  // would take minutes
  for (const unsigned threads : {1u, 2u}) {
    std::atomic<bool> cancel{false};
    ExecutionContext context;
    context.threads = threads;
    context.cancel = &cancel;
    context.onProgress = [&](double) { cancel = true; };
    const GirthField field = girthField(mesh, GirthMethod::Exact, context);
    EXPECT_FALSE(field.complete());
    std::size_t numbers = 0;
    for (const double value : field.values) numbers += std::isfinite(value);
    EXPECT_EQ(numbers, field.computed);

    cancel = true;
    EXPECT_EQ(GirthSolver(mesh).value(Vertex(0), context).error().code, ErrorCode::Cancelled);
    EXPECT_EQ(girthField(mesh, GirthMethod::Exact, context).computed, 0u);
  }
}

TEST(Field, OrderIsCoarseToFine) {
  const SurfaceMesh mesh = octasphere(4).mesh();
  const std::vector<Vertex> order = coarseToFineOrder(mesh);
  EXPECT_EQ(std::set<Index>(order.begin(), order.end()).size(), mesh.vertexCount());
  ASSERT_EQ(order.size(), mesh.vertexCount());
  // The first 32 vertices leave no point of the unit sphere farther away than 60°.
  for (const Vertex v : mesh.vertices()) {
    double nearest = 9;
    for (int i = 0; i < 32; ++i) {
      nearest = std::min(nearest, norm(mesh.position(v) - mesh.position(Vertex(order[i]))));
    }
    EXPECT_LT(nearest, 1);
  }
}

}  // namespace
}  // namespace girth::test
