// Persistent saddles: the barcode of a point, and I_tau.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "barcode_checks.h"
#include "corpus.h"
#include "girth/girth.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth::test {
namespace {

Barcode barcodeOf(GirthSolver& solver, Vertex v, const BarcodeOptions& options = {}) {
  auto barcode = solver.barcode(v, options);
  EXPECT_TRUE(barcode);
  return barcode ? barcode.value() : Barcode{};
}

TEST(Barcode, IsThatOfTheSampledField) {
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) seen += expectSampledBarcodes(seed, 3, 0.035);
  EXPECT_GT(seen, 20);
}

// On flat faces many ways are equally long: several may meet at one point, and go on as one.
TEST(Barcode, IsThatOfTheSampledFieldWhereHeightsAreEqual) {
  int seen = 0;
  for (const Shape& shape :
       {box(1, 1, 1, 3, 3, 3), box(1, 2, 3, 2, 3, 4), prism(regularPolygon(4, 1), 4, 4), plate(1),
        plate(2, 2), plate(3, 1), torus(3, 1, 12, 6), reflected(box(1, 2, 3, 1, 2, 3), 1)}) {
    SCOPED_TRACE(std::to_string(shape.vertexCount()) + " vertices");
    seen += expectSampledBarcodes(shape.mesh(), 0, 3, 0.035);
  }
  EXPECT_GT(seen, 100);
}

TEST(Barcode, HasTwoBarsWithoutEndOnATorus) {
  const SurfaceMesh mesh = perturbed(torus(3, 1, 12, 8), 0.1, 1).mesh();
  GirthSolver solver(mesh);
  for (Index v = 0; v < mesh.vertexCount(); v += 7) {
    const Barcode barcode = barcodeOf(solver, Vertex(v));
    int endless = 0;
    for (const SaddleBar& bar : barcode.bars) endless += std::isinf(bar.death) ? 1 : 0;
    EXPECT_EQ(endless, 2);
  }
}

// Whatever the unit of the model, a length is one: no finite tau passes over what never dies.
TEST(Barcode, KeepsHandlesForAnyTau) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const SurfaceMesh mesh = moved(torus(3, 1, 12, 8), scale, 0, 0).mesh();
    GirthSolver solver(mesh);
    for (const double tau : {1e3 * scale, 1e300, std::numeric_limits<double>::max()}) {
      solver.setPersistence(tau);
      const GirthValue value = solver.value(Vertex(0)).value();
      EXPECT_EQ(value.kind, LoopKind::Loop) << tau;
      EXPECT_EQ(value.length, barcodeOf(solver, Vertex(0)).girth(tau).length);
    }
  }
}

TEST(Barcode, IsEmptyOnARegularSphere) {
  const SurfaceMesh mesh = octasphere(2).mesh();
  GirthSolver solver(mesh);
  const Barcode barcode = barcodeOf(solver, Vertex(0));
  EXPECT_TRUE(barcode.bars.empty());
  EXPECT_EQ(barcode.rest.kind, LoopKind::Antipodal);
  EXPECT_DOUBLE_EQ(barcode.rest.length, solver.value(Vertex(0)).value().length);
}

// I_tau by its own search is what the whole barcode says, for any tau; I_0 is I.
void expectPersistentGirthsAreOfBarcodes(const SurfaceMesh& mesh) {
  GirthSolver solver(mesh), persistent(mesh);
  for (Index v = 0; v < mesh.vertexCount(); v += 1 + mesh.vertexCount() / 8) {
    SCOPED_TRACE("vertex " + std::to_string(v));
    const GirthValue girth = solver.value(Vertex(v)).value();
    const Barcode barcode = barcodeOf(solver, Vertex(v));
    double last = girth.length;
    for (const double share : {0.0, 1e-6, 0.01, 0.03, 0.1, 0.3, 1.0, 1000.0}) {
      const double tau = share * girth.length;
      persistent.setPersistence(tau);
      const GirthValue value = persistent.value(Vertex(v)).value();
      const GirthLoop loop = persistent.loop(Vertex(v)).value();
      EXPECT_EQ(loop.length, value.length);
      EXPECT_EQ(loop.kind, value.kind);
      EXPECT_GE(value.length, last) << "tau " << tau;
      last = value.length;
      if (share == 0) {
        EXPECT_EQ(value.length, girth.length);
        EXPECT_EQ(value.kind, girth.kind);
        continue;
      }
      EXPECT_EQ(value.length, barcode.girth(tau).length) << "tau " << tau;
      EXPECT_EQ(value.kind, barcode.girth(tau).kind);
      const Barcode part = barcodeOf(solver, Vertex(v), {.maxPersistence = tau});
      EXPECT_EQ(part.girth(tau).length, value.length);
      EXPECT_EQ(part.girth(tau / 2).length, barcode.girth(tau / 2).length);
    }
  }
}

TEST(Barcode, GivesThePersistentGirth) {
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectPersistentGirthsAreOfBarcodes(randomMesh(seed, 0.02).shape.mesh(OpenEdges::Boundary));
  }
}

// Saddles and maxima of equal height, on flat faces with many ways of equal length.
TEST(Barcode, GivesThePersistentGirthWhereHeightsAreEqual) {
  for (const Shape& shape : {box(1, 1, 1, 4, 4, 4), box(1, 2, 3, 2, 4, 6), plate(1), plate(2, 2),
                             prism(regularPolygon(4, 1), 4, 6), octasphere(2), tetrahedron()}) {
    expectPersistentGirthsAreOfBarcodes(shape.mesh());
  }
}

// Whether a saddle lasts is mostly seen from its sides. The whole barcode knows it from all maxima,
// at every vertex, and for tau just below and above how long saddles last.
TEST(Barcode, IsForeseenFromTheSidesOfSaddles) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) expectPersistentGirths(seed);
}

// Animals, at vertices where one of the two was wrong once.
TEST(Barcode, IsForeseenOnRealModels) {
  if (!corpusIsThere()) GTEST_SKIP() << "skipped: no corpus";
  const struct {
    const char* name;
    double percent;  // percentage of the square root of the area
    std::vector<Index> vertices;
  } cases[] = {
      {"horse0", 8, {3183, 3672, 3675}},
      {"cat0", 8, {539}},
      {"cat3", 2, {1545, 1912, 2520}},
      {"david0", 2, {3668, 4763}},
      {"wolf0", 2, {2860, 2868, 2870, 2872, 2873, 2874, 2875, 2879, 2885, 2925, 2928, 2945}},
  };
  for (const auto& [name, percent, vertices] : cases) {
    SCOPED_TRACE(name);
    const SurfaceMesh mesh = corpusModel(std::string("../retrieval/tosca_iso_5k/") + name + ".off");
    const double tau = percent / 100 * std::sqrt(mesh.area());
    GirthSolver solver(mesh), persistent(mesh);
    persistent.setPersistence(tau);
    for (const Index v : vertices) {
      SCOPED_TRACE("vertex " + std::to_string(v));
      const Barcode barcode = barcodeOf(solver, Vertex(v), {.maxPersistence = tau});
      EXPECT_EQ(persistent.value(Vertex(v)).value().length, barcode.girth(tau).length);
    }
  }
}

// Far from the ends of a rod both sides of the loop go on, as its length shows: at most vertices
// nothing is computed beyond the loop.
TEST(Barcode, OfARodTakesLittleMoreThanTheLoop) {
  const SurfaceMesh mesh = perturbed(prism(regularPolygon(9, 1), 40, 60), 0.1, 1).mesh();
  GirthSolver plain(mesh), persistent(mesh);
  persistent.setPersistence(4);
  int seen = 0, quick = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double z = mesh.position(Vertex(v)).z;
    if (std::fabs(z - 20) > 5) continue;
    EXPECT_EQ(persistent.value(Vertex(v)).value().length, plain.value(Vertex(v)).value().length);
    const std::size_t windows = plain.statistics().windowsCrossed;
    if (persistent.statistics().windowsCrossed < windows + windows / 5) ++quick;
    ++seen;
  }
  EXPECT_GT(seen, 100);
  EXPECT_GT(quick, seen * 3 / 4);
}

// Neighbours bracket each other; scaling, renumbering and threads change nothing.
TEST(Barcode, IsStableFromPointToPoint) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = randomMesh(seed, 0.02).shape.mesh(OpenEdges::Boundary);
    const auto barcodes = evaluateAll(mesh, barcodeFunction(mesh, {})).values;
    for (Index h = 0; h < mesh.halfedgeCount(); h += 5) {
      const Barcode &p = barcodes[mesh.from(Halfedge(h))], &q = barcodes[mesh.to(Halfedge(h))];
      const double e = mesh.length(Halfedge(h)), slack = 1e-9 * p.girth(0).length;
      for (const double share : {2.0, 2.5, 4.0}) {
        const double tau = share * e, value = q.girth(tau).length;
        EXPECT_GE(value, p.girth(tau - 2 * e).length - 2 * e - slack);
        EXPECT_LE(value, p.girth(tau + 2 * e).length + 2 * e + slack);
      }
    }
  }
}

TEST(Barcode, DoesNotDependOnSizeNumbersOrThreads) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Shape shape = withoutLoneVertices(randomMesh(seed, 0.02).shape);
    const SurfaceMesh mesh = shape.mesh(OpenEdges::Boundary);
    const double tau = 0.05 * girthField(mesh).values[0];
    const GirthField field = girthField(mesh, {.persistence = tau}, ExecutionContext{.threads = 1});
    EXPECT_EQ(girthField(mesh, {.persistence = tau}, ExecutionContext{.threads = 3}).values,
              field.values);

    const SurfaceMesh large = moved(shape, 8, 0, 0).mesh(OpenEdges::Boundary);
    const GirthField scaled = girthField(large, {.persistence = 8 * tau});
    std::vector<Index> newNumber;
    const SurfaceMesh other = relabelled(shape, seed, newNumber).mesh(OpenEdges::Boundary);
    const GirthField renumbered = girthField(other, {.persistence = tau});
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_EQ(scaled.values[v], 8 * field.values[v]);
      EXPECT_EQ(scaled.kinds[v], field.kinds[v]);
      EXPECT_NEAR(renumbered.values[newNumber[v]] / field.values[v], 1, 1e-9);
    }
  }
}

TEST(Barcode, IsALowerBoundWhereTheBudgetEnds) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const SurfaceMesh mesh = randomMesh(seed, 0.02).shape.mesh(OpenEdges::Boundary);
    GirthSolver solver(mesh), poor(mesh);
    const double tau = 0.1 * solver.value(Vertex(0)).value().length;
    solver.setPersistence(tau);
    poor.setPersistence(tau);
    const GirthValue value = solver.value(Vertex(0)).value();
    bool isResolved = false;
    int unresolved = 0;
    for (std::size_t budget = 1; budget < 1u << 26 && !isResolved; budget *= 2) {
      poor.setBudget(budget);
      const GirthValue bound = poor.value(Vertex(0)).value();
      isResolved = bound.kind != LoopKind::Unresolved;
      if (!isResolved) ++unresolved;
      EXPECT_LE(bound.length, value.length * (1 + 1e-12));
      if (isResolved) {
        EXPECT_EQ(bound.length, value.length);
      }
      const GirthLoop loop = poor.loop(Vertex(0)).value();
      EXPECT_EQ(loop.length, bound.length);
      EXPECT_EQ(loop.kind, bound.kind);
      const Barcode barcode = poor.barcode(Vertex(0), {.maxPersistence = tau}).value();
      EXPECT_LE(barcode.girth(tau).length, value.length * (1 + 1e-12));
    }
    EXPECT_TRUE(isResolved);
    EXPECT_GT(unresolved, 0);
  }
}

TEST(Barcode, RefusesWhatIsNoPersistence) {
  const SurfaceMesh mesh = octasphere(1).mesh();
  GirthSolver solver(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double tau : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    solver.setPersistence(tau);
    EXPECT_EQ(solver.value(Vertex(0)).error().code, ErrorCode::InvalidOption);
    EXPECT_EQ(solver.loop(Vertex(0)).error().code, ErrorCode::InvalidOption);
  }
  EXPECT_EQ(solver.barcode(Vertex(0), {.maxPersistence = -1}).error().code,
            ErrorCode::InvalidOption);
  EXPECT_EQ(solver.barcode(Vertex(0), {.maxPersistence = nan}).error().code,
            ErrorCode::InvalidOption);
  EXPECT_EQ(solver.barcode(Vertex(99), {}).error().code, ErrorCode::VertexOutOfRange);
  EXPECT_EQ(girthField(mesh, {.persistence = -1}).computed, 0u);
  EXPECT_EQ(girthField(mesh, {.method = GirthMethod::Marched, .persistence = 1}).computed, 0u);
}

}  // namespace
}  // namespace girth::test
