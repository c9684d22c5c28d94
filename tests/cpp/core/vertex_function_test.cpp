// Functions of the vertices, one by one and all together.

#include "girth/vertex_function.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "girth/geodesic_extent.h"
#include "girth/girth_field.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "girth/study/naive_girth.h"
#include "shapes.h"

namespace girth::test {
namespace {

/// Bits, so that NaN equals itself.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return true;
}

struct Named {
  const char* name;
  VertexFunction<double> function;
  std::vector<double> all;
};

/// The lengths of a girth function.
VertexFunction<double> lengths(const VertexFunction<GirthValue>& girth) {
  return {[girth](const ExecutionContext& context) -> VertexEvaluator<double> {
    return [evaluate = girth.evaluator(context)](Index v) -> Result<double> {
      const auto value = evaluate(Vertex(v));
      if (!value) return value.error();
      return value.value().length;
    };
  }};
}

std::vector<Named> functionsOf(const SurfaceMesh& mesh) {
  const GeodesicExtent marched = geodesicExtent(mesh, DistanceMethod::FastMarching);
  const GeodesicExtent exact = geodesicExtent(mesh, DistanceMethod::Exact);
  return {
      {"girth", lengths(girthFunction(mesh)), girthField(mesh).values},
      {"marched girth", lengths(girthFunction(mesh, GirthMethod::Marched)),
       girthField(mesh, GirthMethod::Marched).values},
      {"naive girth", lengths(study::naiveGirthFunction(mesh)),
       study::naiveGirthField(mesh).values},
      {"shape diameter", shapeDiameterFunction(mesh).value(), shapeDiameter(mesh).value().values},
      {"mean distance",
       geodesicExtentFunction(mesh, ExtentMeasure::Average, DistanceMethod::FastMarching),
       marched.average},
      {"greatest distance",
       geodesicExtentFunction(mesh, ExtentMeasure::Farthest, DistanceMethod::FastMarching),
       marched.farthest},
      {"exact mean distance",
       geodesicExtentFunction(mesh, ExtentMeasure::Average, DistanceMethod::Exact), exact.average},
      {"exact greatest distance",
       geodesicExtentFunction(mesh, ExtentMeasure::Farthest, DistanceMethod::Exact),
       exact.farthest},
  };
}

TEST(VertexFunction, OneByOneAsAllTogether) {
  const SurfaceMesh mesh = perturbed(octasphere(2), 0.1, 3).mesh();
  for (const Named& named : functionsOf(mesh)) {
    SCOPED_TRACE(named.name);
    const ExecutionContext context;
    const VertexEvaluator<double> evaluate = named.function.evaluator(context);
    std::vector<double> values(mesh.vertexCount());
    // Backwards: what was computed before must not matter.
    for (Index v = mesh.vertexCount(); v-- > 0;) values[v] = evaluate(Vertex(v)).value();
    EXPECT_TRUE(same(values, named.all));
    for (const unsigned threads : {1u, 3u}) {
      ExecutionContext several;
      several.threads = threads;
      const VertexValues<double> all = evaluateAll(mesh, named.function, several);
      EXPECT_TRUE(all.complete());
      EXPECT_TRUE(same(all.values, named.all));
    }
    EXPECT_EQ(evaluate(Vertex(mesh.vertexCount())).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(evaluate(Vertex(kNoIndex)).error().code, ErrorCode::VertexOutOfRange);
    EXPECT_EQ(evaluate(Vertex(0)).value(), named.all[0]);
  }
}

TEST(VertexFunction, SomeVerticesHaveTheValuesOfAll) {
  const SurfaceMesh mesh = perturbed(octasphere(2), 0.1, 3).mesh();
  const std::vector<Vertex> order = coarseToFineOrder(mesh);
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 3);
  for (const Named& named : functionsOf(mesh)) {
    SCOPED_TRACE(named.name);
    std::vector<double> joined(mesh.vertexCount());
    for (const std::vector<Vertex>& some :
         {std::vector(order.begin(), middle), std::vector(middle, order.end())}) {
      std::size_t reported = 0;
      const auto report = [&](const VertexPartial<double>& partial) {
        for (const Vertex v : partial.vertices) joined[v] = named.all[v];
        reported += partial.vertices.size();
      };
      const VertexValues<double> found = evaluateAt(mesh, named.function, some, {}, report);
      EXPECT_EQ(found.computed, some.size());
      EXPECT_EQ(reported, some.size());
      EXPECT_EQ(found.values.size(), mesh.vertexCount());
      for (const Vertex v : some) EXPECT_TRUE(same({found.values[v]}, {named.all[v]})) << v;
    }
    EXPECT_TRUE(same(joined, named.all));
    EXPECT_EQ(evaluateAt(mesh, named.function, {}).computed, 0u);
    const std::vector<Vertex> none = {Vertex(mesh.vertexCount())};
    EXPECT_EQ(evaluateAt(mesh, named.function, none).computed, 0u);
  }
}

TEST(VertexFunction, EvaluatorsOutliveTheirFunction) {
  const SurfaceMesh mesh = octasphere(2).mesh();
  const ExecutionContext context;
  std::vector<std::pair<VertexEvaluator<double>, double>> evaluators;
  for (const Named& named : functionsOf(mesh)) {
    evaluators.emplace_back(named.function.evaluator(context), named.all[5]);
  }
  for (const auto& [evaluate, value] : evaluators) EXPECT_EQ(evaluate(Vertex(5)).value(), value);
}

TEST(VertexFunction, AngleIsThatOfTheLoop) {
  const SurfaceMesh mesh = perturbed(octasphere(2), 0.2, 1).mesh();
  const VertexValues<double> angles = evaluateAll(mesh, loopAngleFunction(mesh));
  GirthSolver solver(mesh);
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(angles.values[v], solver.loop(v).value().angle) << v;
  }
}

TEST(VertexFunction, StopsWhenTold) {
  const SurfaceMesh few = octasphere(1).mesh(), mesh = octasphere(4).mesh();
  for (const Named& named : functionsOf(few)) {
    SCOPED_TRACE(named.name);
    std::atomic<bool> stopped{true};
    ExecutionContext context;
    context.cancel = &stopped;
    EXPECT_EQ(evaluateAll(few, named.function, context).computed, 0u);
  }
  const VertexFunction<double> far =
      geodesicExtentFunction(mesh, ExtentMeasure::Average, DistanceMethod::Exact);
  std::atomic<bool> cancel{false};
  ExecutionContext context;
  context.cancel = &cancel;
  context.onProgress = [&](double) { cancel = true; };
  const VertexValues<double> values = evaluateAll(mesh, far, context);
  EXPECT_LT(values.computed, values.values.size());
  std::size_t numbers = 0;
  for (const double value : values.values) numbers += std::isfinite(value);
  EXPECT_EQ(numbers, values.computed);
}

TEST(VertexFunction, ExceptionsReachTheCaller) {
  const SurfaceMesh mesh = octasphere(3).mesh();
  const VertexFunction<int> failing{[](const ExecutionContext&) -> VertexEvaluator<int> {
    return [](Index v) -> Result<int> {
      if (v == 7) throw std::bad_alloc();
      return 1;
    };
  }};
  for (const unsigned threads : {1u, 4u}) {
    ExecutionContext context;
    context.threads = threads;
    EXPECT_THROW(evaluateAll(mesh, failing, context), std::bad_alloc);
    const auto work = [](std::size_t begin, std::size_t) {
      if (begin == 90) throw std::out_of_range("90");
    };
    EXPECT_THROW(parallelFor(1000, 10, context, work), std::out_of_range);
  }
}

TEST(VertexFunction, OptionsAreChecked) {
  const SurfaceMesh mesh = octasphere(1).mesh();
  EXPECT_EQ(shapeDiameterFunction(mesh, {0, 30}).error().code, ErrorCode::Usage);
  EXPECT_EQ(shapeDiameterFunction(mesh, {1, 0}).error().code, ErrorCode::Usage);
}

TEST(VertexFunction, NotesSayWhatIsMissing) {
  EXPECT_EQ(budgetNote(0, 9), "");
  EXPECT_NE(budgetNote(2, 9).find("2 of 9 vertices"), std::string::npos);
  EXPECT_EQ(shapeDiameterNote(false, 0, 9), "");
  EXPECT_NE(shapeDiameterNote(true, 0, 9).find("inside out"), std::string::npos);
  const std::string both = shapeDiameterNote(true, 3, 9);
  EXPECT_NE(both.find("turn the faces over. 3 of 9 vertices"), std::string::npos);
}

}  // namespace
}  // namespace girth::test
