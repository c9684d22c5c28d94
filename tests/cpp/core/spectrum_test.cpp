// The spectrum: shapes whose eigenvalues are known in closed form, and surfaces that are hard.
#include "girth/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "girth/vertex_areas.h"
#include "mesh/angles.h"
#include "random_meshes.h"
#include "shapes.h"

namespace girth {
namespace {

using test::Shape;

Spectrum spectrumOf(const SurfaceMesh& mesh, Index pairs) {
  auto spectrum = laplaceSpectrum(mesh, {pairs});
  EXPECT_TRUE(spectrum.ok()) << (spectrum.ok() ? "" : spectrum.error().message);
  return spectrum.ok() ? std::move(spectrum).value() : Spectrum{};
}

/// A tube of `around` × `along` rectangles, open at both ends.
Shape openTube(double perimeter, double height, Index around, Index along) {
  Shape shape;
  const std::vector<double> polygon = test::regularPolygon(around, perimeter / around);
  for (Index ring = 0; ring <= along; ++ring) {
    for (Index i = 0; i < around; ++i) {
      shape.add(polygon[2 * i], polygon[2 * i + 1], height * ring / along);
    }
  }
  for (Index ring = 0; ring < along; ++ring) {
    for (Index i = 0; i < around; ++i) {
      const Index a = ring * around + i, b = ring * around + (i + 1) % around;
      shape.face(a, b, b + around);
      shape.face(a, b + around, a + around);
    }
  }
  return shape;
}

/// A flat torus: two such tubes in the same place, joined at both ends.
Shape flatTorus(double perimeter, double length, Index around, Index along) {
  const Index half = along / 2;
  Shape shape = openTube(perimeter, length / 2, around, half);
  const Index first = shape.vertexCount();
  for (Index v = around; v < half * around; ++v) {
    shape.add(shape.positions[3 * v], shape.positions[3 * v + 1], shape.positions[3 * v + 2]);
  }
  const auto copy = [&](Index v) {
    return v < around || v >= half * around ? v : v - around + first;
  };
  const std::vector<Index> triangles = shape.triangles;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    shape.face(copy(triangles[i]), copy(triangles[i + 2]), copy(triangles[i + 1]));
  }
  return shape;
}

/// The second derivative as rectangles, cut in two, have it: (2 − 2 cos(h ω)) / h².
double discreteSquare(double omega, double h) { return (2 - 2 * std::cos(h * omega)) / (h * h); }

/// L φ − λ M φ, made of the mesh's own faces: only where they are Delaunay already.
double residual(const SurfaceMesh& mesh, const Spectrum& spectrum, std::size_t k) {
  const std::size_t n = mesh.vertexCount();
  const double* phi = &spectrum.vectors[k * n];
  std::vector<double> rest(n, 0);
  for (const Halfedge h : mesh.halfedges()) {
    const double weight = 0.5 / std::tan(mesh.cornerAngle(SurfaceMesh::previous(h)));
    const double flow = weight * (phi[mesh.from(h)] - phi[mesh.to(h)]);
    rest[mesh.from(h)] += flow;
    rest[mesh.to(h)] -= flow;
  }
  double sum = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const double r = rest[v] - spectrum.values[k] * spectrum.areas[v] * phi[v];
    sum += r * r / spectrum.areas[v];
  }
  return std::sqrt(sum);
}

void expectOrthonormal(const Spectrum& spectrum) {
  const std::size_t n = spectrum.areas.size();
  double worst = 0;
  for (std::size_t j = 0; j < spectrum.values.size(); ++j) {
    for (std::size_t k = j; k < spectrum.values.size(); ++k) {
      double product = 0;
      for (std::size_t v = 0; v < n; ++v) {
        product += spectrum.areas[v] * spectrum.vectors[j * n + v] * spectrum.vectors[k * n + v];
      }
      worst = std::max(worst, std::fabs(product - (j == k ? 1 : 0)));
    }
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(Spectrum, OfASphereIsThatOfSphericalHarmonics) {
  const SurfaceMesh mesh = test::icosphere(4).mesh();
  const Spectrum spectrum = spectrumOf(mesh, 49);
  ASSERT_EQ(spectrum.values.size(), 49u);
  EXPECT_EQ(spectrum.values[0], 0);
  std::size_t k = 0;
  for (int l = 0; l <= 6; ++l) {
    for (int m = -l; m <= l; ++m, ++k) {
      EXPECT_NEAR(spectrum.values[k], l * (l + 1), 0.02 * l * (l + 1)) << "pair " << k;
      EXPECT_LT(residual(mesh, spectrum, k), 1e-8 * (1 + spectrum.values[k])) << "pair " << k;
    }
  }
  expectOrthonormal(spectrum);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_NEAR(spectrum.vectors[v], 1 / std::sqrt(mesh.area()), 1e-12);
  }
}

/// Both ways: all pairs of the full matrix, and some by Lanczos. The values are known exactly, with
/// up to eight copies of each.
TEST(Spectrum, OfAFlatTorusToTheLastCopy) {
  const Index around = 24, along = 24;
  const SurfaceMesh mesh = flatTorus(24, 24, around, along).mesh();
  ASSERT_EQ(mesh.genus(0), 1u);
  std::vector<double> expected;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < along; ++j) {
      expected.push_back(discreteSquare(2 * kPi * i / 24, 1) + discreteSquare(2 * kPi * j / 24, 1));
    }
  }
  std::sort(expected.begin(), expected.end());
  for (const Index pairs : {60u, 61u, 62u, 63u, 150u, 576u}) {
    const Spectrum spectrum = spectrumOf(mesh, pairs);
    ASSERT_EQ(spectrum.values.size(), pairs);
    for (std::size_t k = 0; k < pairs; ++k) {
      ASSERT_NEAR(spectrum.values[k], expected[k], 1e-9) << "pair " << k << " of " << pairs;
    }
    expectOrthonormal(spectrum);
  }
}

TEST(Spectrum, BoundariesReflect) {
  // A tube open at both ends: cosines along it.
  const SurfaceMesh tube = openTube(10, 7, 40, 28).mesh(OpenEdges::Boundary);
  std::vector<double> expected;
  for (Index i = 0; i < 40; ++i) {
    for (Index j = 0; j <= 28; ++j) {
      expected.push_back(discreteSquare(2 * kPi * i / 10, 0.25) +
                         discreteSquare(kPi * j / 7, 0.25));
    }
  }
  std::sort(expected.begin(), expected.end());
  const Spectrum spectrum = spectrumOf(tube, 100);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_NEAR(spectrum.values[k], expected[k], 1e-9);

  // A disk of radius 1: squares of the zeros of the Bessel functions' derivatives.
  Shape disk;
  const Index rings = 40;
  disk.add(0, 0, 0);
  for (Index r = 1; r <= rings; ++r) {
    for (Index i = 0; i < 6 * r; ++i) {
      const double angle = 2 * kPi * i / (6 * r), radius = double(r) / rings;
      disk.add(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  for (Index r = 1; r <= rings; ++r) {
    const Index outer = 1 + 3 * r * (r - 1), inner = r == 1 ? 0 : 1 + 3 * (r - 1) * (r - 2);
    for (Index side = 0; side < 6; ++side) {
      for (Index i = 0; i < r; ++i) {
        const Index o = side * r + i, in = side * (r - 1) + i;
        const auto innerAt = [&](Index k) { return r == 1 ? 0 : inner + k % (6 * (r - 1)); };
        const auto outerAt = [&](Index k) { return outer + k % (6 * r); };
        disk.face(innerAt(in), outerAt(o), outerAt(o + 1));
        if (i + 1 < r) disk.face(innerAt(in), outerAt(o + 1), innerAt(in + 1));
      }
    }
  }
  const Spectrum drum = spectrumOf(disk.mesh(OpenEdges::Boundary), 9);
  const double zeros[] = {0,         1.8411838, 1.8411838, 3.0542369, 3.0542369,
                          3.8317060, 4.2011889, 4.2011889, 5.3175531};
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_NEAR(std::sqrt(drum.values[k]), zeros[k], 0.005 * zeros[k]) << "pair " << k;
  }
}

TEST(Spectrum, MovesWithTheSurfaceAndShrinksWithItsSize) {
  const Shape shape = test::perturbed(test::torus(3, 1, 40, 20), 0.2, 9);
  const Spectrum one = spectrumOf(shape.mesh(), 40);
  const Spectrum moved = spectrumOf(test::moved(shape, 1, 0.7, 5).mesh(), 40);
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_NEAR(moved.values[k], one.values[k], 1e-9 * one.values[k]);
  }
  for (const double scale : {1e-100, 1e-3, 7.0, 1e100}) {
    const Spectrum scaled = spectrumOf(test::moved(shape, scale, 0, 0).mesh(), 40);
    for (std::size_t k = 0; k < 40; ++k) {
      EXPECT_NEAR(scaled.values[k] * scale * scale, one.values[k], 1e-9 * one.values[k]);
    }
    for (std::size_t v = 0; v < one.areas.size(); ++v) {
      EXPECT_NEAR(scaled.areas[v] / scale / scale, one.areas[v], 1e-12 * one.areas[v]);
      // The second function is alone with its value, so it is the same.
      EXPECT_NEAR(scaled.vectors[3 * one.areas.size() + v] * scale,
                  one.vectors[3 * one.areas.size() + v], 1e-6);
    }
  }
}

TEST(Spectrum, IsThatOfTheSurfaceAndNotOfItsTriangles) {
  // Flat faces, cut by other diagonals: the intrinsic Delaunay triangulation is the same,
  // where no four vertices lie on a circle.
  const Shape shape = test::subdivided(test::perturbed(test::icosphere(2), 0.2, 4));
  const Spectrum one = spectrumOf(shape.mesh(), 30);
  const Spectrum other = spectrumOf(test::retriangulated(shape, 5).mesh(), 30);
  for (std::size_t k = 0; k < 30; ++k) {
    EXPECT_NEAR(other.values[k], one.values[k], 1e-6 * one.values[k]);
  }
}

TEST(Spectrum, NeedlesDoNotHurt) {
  // Vertices almost on the sides of other faces, at distances down to what a surface may have.
  Shape shape = test::icosphere(2);
  const Spectrum plain = spectrumOf(shape.mesh(), 16);
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const std::size_t f = random.below(static_cast<Index>(shape.triangles.size() / 3));
    const Index a = shape.triangles[3 * f], b = shape.triangles[3 * f + 1],
                c = shape.triangles[3 * f + 2];
    const double height = std::pow(10.0, -2 - 9 * random()), t = 0.2 + 0.6 * random();
    const double weight[3] = {(1 - height) * t, (1 - height) * (1 - t), height};
    double p[3];
    for (std::size_t x = 0; x < 3; ++x) {
      p[x] = weight[0] * shape.positions[3 * a + x] + weight[1] * shape.positions[3 * b + x] +
             weight[2] * shape.positions[3 * c + x];
    }
    Shape next = shape;
    const Index v = next.add(p[0], p[1], p[2]);
    next.triangles[3 * f + 2] = v;
    next.face(b, c, v);
    next.face(c, a, v);
    if (SurfaceMesh::fromArrays(next.positions, next.triangles).ok()) shape = std::move(next);
  }
  const SurfaceMesh mesh = shape.mesh();
  ASSERT_GT(mesh.vertexCount(), 300u);
  const Spectrum spectrum = spectrumOf(mesh, 16);
  double area = 0;
  for (const double share : spectrum.areas) {
    EXPECT_GT(share, 0);
    area += share;
  }
  EXPECT_NEAR(area, mesh.area(), 1e-4 * mesh.area());
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_NEAR(spectrum.values[k], plain.values[k], 0.1 * plain.values[k]) << "pair " << k;
  }
  expectOrthonormal(spectrum);
}

TEST(Spectrum, AreasAreThoseOfTheVerticesWhereNoEdgeIsFlipped) {
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  const Spectrum spectrum = spectrumOf(mesh, 5);
  const std::vector<double> areas = vertexAreas(mesh);
  for (std::size_t v = 0; v < areas.size(); ++v) EXPECT_NEAR(spectrum.areas[v], areas[v], 1e-12);
}

TEST(Spectrum, EveryComponentHasItsOwn) {
  // Two spheres, equal but for their size, and a small tetrahedron.
  Shape shape = test::icosphere(3);
  const Index n = shape.vertexCount();
  for (const auto& [part, scale] :
       {std::pair(test::icosphere(3), 0.5), {test::tetrahedron(), 0.1}}) {
    const Index first = shape.vertexCount();
    for (Index v = 0; v < part.vertexCount(); ++v) {
      shape.add(5 + scale * part.positions[3 * v], scale * part.positions[3 * v + 1],
                scale * part.positions[3 * v + 2]);
    }
    for (const Index v : part.triangles) shape.triangles.push_back(first + v);
  }
  const SurfaceMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.componentCount(), 3u);
  const Spectrum both = spectrumOf(mesh, 120);
  const Spectrum one = spectrumOf(test::icosphere(3).mesh(), 120);
  std::vector<double> expected{0};
  for (const double value : one.values) {
    expected.push_back(value);
    expected.push_back(4 * value);
  }
  for (const double value : spectrumOf(test::tetrahedron().mesh(), 4).values) {
    if (value > 0) expected.push_back(100 * value);
  }
  std::sort(expected.begin(), expected.end());
  for (std::size_t k = 0; k < 120; ++k) {
    EXPECT_NEAR(both.values[k], expected[k], 1e-8 * expected[k]) << "pair " << k;
    double inFirst = 0;
    for (Index v = 0; v < n; ++v) {
      inFirst = std::max(inFirst, std::fabs(both.vectors[k * mesh.vertexCount() + v]));
    }
    double elsewhere = 0;
    for (Index v = n; v < mesh.vertexCount(); ++v) {
      elsewhere = std::max(elsewhere, std::fabs(both.vectors[k * mesh.vertexCount() + v]));
    }
    EXPECT_EQ(std::min(inFirst, elsewhere), 0) << "pair " << k;
  }
  EXPECT_EQ(both.values[2], 0);
  EXPECT_GT(both.values[3], 0);
}

TEST(Spectrum, OfTheSmallestSurfaces) {
  // A regular tetrahedron of side s: three copies of 4 w / m, w = cot 60°, m = a quarter of √3 s².
  const SurfaceMesh mesh = test::tetrahedron().mesh();
  const double s = mesh.length(Halfedge(0));
  const Spectrum spectrum = spectrumOf(mesh, 300);
  ASSERT_EQ(spectrum.values.size(), 4u);
  EXPECT_EQ(spectrum.values[0], 0);
  const double expected = 4 * (1 / std::sqrt(3.0)) / (std::sqrt(3.0) / 4 * s * s);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(spectrum.values[k], expected, 1e-12 * expected);
  Shape triangle;
  triangle.add(0, 0, 0);
  triangle.add(1, 0, 0);
  triangle.add(0, 1, 0);
  triangle.face(0, 1, 2);
  EXPECT_EQ(spectrumOf(triangle.mesh(OpenEdges::Boundary), 1).values.size(), 1u);
  EXPECT_EQ(spectrumOf(triangle.mesh(OpenEdges::Boundary), 3).values.size(), 3u);
}

TEST(Spectrum, OfRandomSurfaces) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const test::RandomMesh random = test::randomMesh(seed);
    SCOPED_TRACE(random.history);
    const SurfaceMesh mesh = random.shape.mesh(OpenEdges::Boundary);
    const Spectrum spectrum = spectrumOf(mesh, 12);
    ASSERT_EQ(spectrum.values.size(), std::min(12u, mesh.vertexCount()));
    EXPECT_EQ(spectrum.values[0], 0);
    EXPECT_GT(spectrum.values[1], 0);
    EXPECT_TRUE(std::is_sorted(spectrum.values.begin(), spectrum.values.end()));
    expectOrthonormal(spectrum);
  }
}

TEST(Spectrum, IsRepeatable) {
  const SurfaceMesh mesh = test::perturbed(test::icosphere(3), 0.2, 3).mesh();
  const Spectrum one = spectrumOf(mesh, 30);
  ExecutionContext context;
  context.threads = 1;
  double last = -1;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  const auto again = laplaceSpectrum(mesh, {30}, context);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.value().values, one.values);
  EXPECT_EQ(again.value().vectors, one.vectors);
  EXPECT_EQ(last, 1);
  for (std::size_t k = 0; k < 30; ++k) {
    const auto begin = one.vectors.begin() + std::ptrdiff_t(k * mesh.vertexCount());
    const auto [low, high] = std::minmax_element(begin, begin + mesh.vertexCount());
    EXPECT_GE(*high, -*low * (1 - 2e-6)) << "pair " << k;
  }
}

TEST(Spectrum, StopsAndRefuses) {
  const SurfaceMesh mesh = test::icosphere(3).mesh();
  const auto none = laplaceSpectrum(mesh, {0});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, ErrorCode::InvalidOption);
  std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  auto stopped = laplaceSpectrum(mesh, {}, context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  // In the middle of the work.
  cancel = false;
  context.onProgress = [&](double fraction) { cancel = fraction > 0.1; };
  stopped = laplaceSpectrum(mesh, {50}, context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth
