// From triangles to a surface: drawn cases for every step, and random soups.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "girth/prepare_surface.h"
#include "random_soups.h"
#include "shapes.h"

namespace girth::test {
namespace {

TriangleSoup soupOf(const Shape& shape) { return {shape.positions, shape.triangles}; }

PreparedSurface prepared(const Shape& shape, const PrepareOptions& options = {}) {
  auto result = prepareSurface(soupOf(shape), options);
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().message);
  return result ? std::move(result).value() : prepareSurface(soupOf(tetrahedron())).value();
}

std::string codeOf(const Result<PreparedSurface>& result) {
  return result ? "OK" : std::string(toString(result.error().code));
}

/// A unit cube with its lowest corner at a place, eight vertices and twelve faces.
void addCube(Shape& shape, double x, double y, double z) {
  Index v[8];
  for (Index i = 0; i < 8; ++i) v[i] = shape.add(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
  const auto side = [&](Index a, Index b, Index c, Index d) {
    shape.face(v[a], v[b], v[c]);
    shape.face(v[a], v[c], v[d]);
  };
  side(0, 2, 3, 1);
  side(4, 5, 7, 6);
  side(0, 1, 5, 4);
  side(2, 6, 7, 3);
  side(0, 4, 6, 2);
  side(1, 3, 7, 5);
}

Shape cubesAt(const std::vector<std::array<double, 3>>& places) {
  Shape shape;
  for (const auto& p : places) addCube(shape, p[0], p[1], p[2]);
  return shape;
}

void turnOver(Shape& shape, std::size_t face) {
  std::swap(shape.triangles[3 * face + 1], shape.triangles[3 * face + 2]);
}

/// Every corner a vertex of its own.
Shape apart(const Shape& shape) {
  Shape soup;
  for (const Index v : shape.triangles) {
    soup.triangles.push_back(
        soup.add(shape.positions[3 * v], shape.positions[3 * v + 1], shape.positions[3 * v + 2]));
  }
  return soup;
}

/// A box each of whose six sides has vertices of its own, as flat shading asks for.
Shape sidesApart(const Shape& box) {
  Shape sides;
  std::map<std::array<Index, 2>, Index> numberOf;  // by axis of the side and vertex
  for (std::size_t f = 0; f < box.triangles.size() / 3; ++f) {
    const Index* v = &box.triangles[3 * f];
    const auto at = [&](Index corner, std::size_t k) { return box.positions[3 * corner + k]; };
    Index axis = 0;
    while (at(v[0], axis) != at(v[1], axis) || at(v[0], axis) != at(v[2], axis)) ++axis;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [entry, isNew] = numberOf.try_emplace({axis, v[i]}, 0);
      if (isNew) entry->second = sides.add(at(v[i], 0), at(v[i], 1), at(v[i], 2));
      sides.triangles.push_back(entry->second);
    }
  }
  return sides;
}

Shape oneVertexAtEachPlace(const Shape& shape) {
  Shape joined;
  std::map<std::array<double, 3>, Index> at;
  for (const Index v : shape.triangles) {
    const double* p = &shape.positions[3 * std::size_t{v}];
    const auto [entry, isNew] = at.try_emplace({p[0], p[1], p[2]}, 0);
    if (isNew) entry->second = joined.add(p[0], p[1], p[2]);
    joined.triangles.push_back(entry->second);
  }
  return joined;
}

double sixfoldVolume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) {
    const auto [i, j, k] = mesh.faceVertices(f);
    const Vec3 &a = mesh.position(Vertex(i)), &b = mesh.position(Vertex(j)),
               &c = mesh.position(Vertex(k));
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum;
}

Index boundaries(const SurfaceMesh& mesh) {
  Index count = 0;
  for (Index c = 0; c < mesh.componentCount(); ++c) count += mesh.boundaryCount(c);
  return count;
}

/// Checks rules that must hold of every result, by the counts and by geometry.
void expectConsistent(const TriangleSoup& input, const PreparedSurface& out) {
  const PreparationReport& report = out.report;
  const SurfaceMesh& mesh = out.mesh;
  EXPECT_EQ(report.inputVertices, input.positions.size() / 3);
  EXPECT_EQ(report.inputFaces, input.triangles.size() / 3);
  ASSERT_EQ(out.vertexOfInput.size(), input.positions.size() / 3);
  ASSERT_EQ(out.inputOfVertex.size(), mesh.vertexCount());
  ASSERT_EQ(out.inputOfFace.size(), mesh.faceCount());
  EXPECT_EQ(out.parts.size(), report.components);
  EXPECT_EQ(mesh.componentCount(), report.keptComponents);
  EXPECT_EQ(boundaries(mesh), report.boundaryCurves);
  if (report.keptComponents == report.components && report.closedHoles == 0) {
    EXPECT_EQ(report.inputVertices - report.weldedVertices - report.unreferencedVertices +
                  report.addedVertices,
              mesh.vertexCount());
    EXPECT_EQ(
        report.inputFaces + report.addedFaces - report.degenerateFaces - report.duplicateFaces,
        mesh.faceCount());
    std::size_t faces = 0;
    double area = 0;
    for (const SurfacePart& part : out.parts) {
      faces += part.faces;
      area += part.area;
    }
    EXPECT_EQ(faces, mesh.faceCount());
    EXPECT_NEAR(area, mesh.area(), 1e-12 * mesh.area());
  }
  for (const Vertex v : mesh.vertices()) {
    const Index from = out.inputOfVertex[v];
    if (from == kNoIndex) continue;
    ASSERT_LT(from, report.inputVertices);
    EXPECT_EQ(mesh.position(v).x, input.positions[3 * from]);
    EXPECT_EQ(mesh.position(v).y, input.positions[3 * from + 1]);
    EXPECT_EQ(mesh.position(v).z, input.positions[3 * from + 2]);
    // The vertex that its input names is a copy of it.
    const Index copy = out.vertexOfInput[from];
    ASSERT_NE(copy, kNoIndex);
    EXPECT_EQ(out.inputOfVertex[copy], from);
  }
}

/// The faces of the input, by the places of their corners, whichever way they are turned.
using PlacedFace = std::array<std::array<double, 3>, 3>;
PlacedFace placed(std::array<std::array<double, 3>, 3> corners) {
  for (auto& corner : corners) {
    for (double& x : corner) x += 0.0;  // −0 is 0
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Every face covers the triangle of the input that it names.
void expectFacesOfTheInput(const TriangleSoup& input, const PreparedSurface& out) {
  for (const Face f : out.mesh.faces()) {
    ASSERT_LT(out.inputOfFace[f], out.report.inputFaces);
    PlacedFace there, here;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = input.triangles[3 * std::size_t{out.inputOfFace[f]} + k];
      there[k] = {input.positions[3 * v], input.positions[3 * v + 1], input.positions[3 * v + 2]};
      const Vec3& p = out.mesh.position(Vertex(out.mesh.faceVertices(f)[k]));
      here[k] = {p.x, p.y, p.z};
    }
    EXPECT_EQ(placed(here), placed(there)) << "face " << f;
  }
}

TriangleSoup arraysOf(const SurfaceMesh& mesh) {
  TriangleSoup soup;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    soup.positions.insert(soup.positions.end(), {p.x, p.y, p.z});
  }
  for (const Halfedge h : mesh.halfedges()) soup.triangles.push_back(mesh.from(h));
  return soup;
}

void expectPreparedOnceIsEnough(const PreparedSurface& out) {
  const TriangleSoup arrays = arraysOf(out.mesh);
  const auto again = prepareSurface(arrays);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(arraysOf(again.value().mesh).positions, arrays.positions);
  EXPECT_EQ(arraysOf(again.value().mesh).triangles, arrays.triangles);
  EXPECT_EQ(again.value().report.reorientedFaces, 0u);
  EXPECT_EQ(again.value().report.degenerateFaces, 0u);
  EXPECT_EQ(again.value().report.duplicateFaces, 0u);
}

void expectSound(const Shape& input, const PreparedSurface& out) {
  expectConsistent(soupOf(input), out);
  expectPreparedOnceIsEnough(out);
}

/// A surface some vertices of which have been put onto others: it touches, crosses and doubles
/// itself; with some faces turned or gone.
Shape gluedSurface(std::uint64_t seed) {
  Random random(seed);
  const Shape shapes[] = {octasphere(1), plate(1), torus(3, 1, 6, 4), icosphere(1)};
  Shape shape = shapes[random.below(4)];
  for (Index glued = random.below(8); glued > 0; --glued) {
    const Index a = random.below(shape.vertexCount()), b = random.below(shape.vertexCount());
    for (std::size_t k = 0; k < 3; ++k) shape.positions[3 * a + k] = shape.positions[3 * b + k];
  }
  const Shape whole = shape;
  shape.triangles.clear();
  for (std::size_t f = 0; f < whole.triangles.size() / 3; ++f) {
    const Index* v = &whole.triangles[3 * f];
    if (random() < 0.02) continue;
    random() < 0.1 ? shape.face(v[0], v[2], v[1]) : shape.face(v[0], v[1], v[2]);
  }
  return shape;
}

// --- Steps ---------------------------------------------------------------------------------------

TEST(Prepare, LeavesAGoodSurfaceAlone) {
  for (const Shape& shape : {tetrahedron(), icosphere(2), plate(2), torus(3, 1, 12, 7)}) {
    const PreparedSurface out = prepared(shape);
    EXPECT_EQ(arraysOf(out.mesh).positions, shape.positions);
    EXPECT_EQ(arraysOf(out.mesh).triangles, shape.triangles);
    EXPECT_EQ(out.report.weldedVertices + out.report.degenerateFaces + out.report.flippedFaces +
                  out.report.duplicateFaces + out.report.unreferencedVertices +
                  out.report.reorientedFaces + out.report.oneSidedEdges +
                  out.report.nonManifoldEdges + out.report.nonManifoldVertices +
                  out.report.addedVertices + out.report.boundaryCurves,
              0u);
    EXPECT_EQ(out.report.components, 1u);
    expectSound(shape, out);
  }
}

TEST(Prepare, WeldsEqualPositions) {
  const Shape ball = icosphere(2);
  const PreparedSurface out = prepared(apart(ball));
  EXPECT_EQ(out.mesh.vertexCount(), ball.vertexCount());
  EXPECT_EQ(out.report.weldedVertices, ball.triangles.size() - ball.vertexCount());
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(apart(ball), out);

  Shape shape = tetrahedron();
  for (double& x : shape.positions) x += 0.0;
  shape.add(-0.0, 0, 0);
  shape.add(0, -0.0, 0);
  shape.add(0, 0, 0);
  shape.triangles = {4, 6, 5};
  EXPECT_EQ(codeOf(prepareSurface(soupOf(shape))), "EMPTY_MESH") << "0 and -0 are one place";
}

TEST(Prepare, MakesAModelLargerOrSmallerFirst) {
  const Shape ball = icosphere(1);
  PrepareOptions options;
  const SurfaceMesh once = prepared(ball).mesh;
  options.scale = 4;
  const SurfaceMesh large = prepared(ball, options).mesh;
  EXPECT_EQ(large.area(), 16 * once.area()) << "powers of two are exact";
  EXPECT_EQ(large.meanEdgeLength(), 4 * once.meanEdgeLength());
  // Lengths to weld within count in the scaled model.
  options.weldDistance = 1.5 * once.meanEdgeLength();
  EXPECT_EQ(prepared(ball, options).mesh.vertexCount(), once.vertexCount());
  options.weldDistance = 0;
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::max()}) {
    options.scale = bad;
    Shape giant = ball;
    for (double& coordinate : giant.positions) coordinate *= 4;
    EXPECT_EQ(codeOf(prepareSurface(soupOf(giant), options)), "INVALID_OPTION") << bad;
  }
}

TEST(Prepare, WeldsWithinADistance) {
  const Shape ball = icosphere(2);
  Shape soup = apart(ball);
  Random random(3);
  for (double& x : soup.positions) x += 1e-6 * (random() - 0.5);
  EXPECT_GT(prepared(soup).report.boundaryCurves, 100u);
  PrepareOptions options;
  options.weldDistance = 1e-5;
  const PreparedSurface out = prepared(soup, options);
  EXPECT_EQ(out.mesh.vertexCount(), ball.vertexCount());
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(soup, out);

  // A row of vertices half the distance apart: each joins the nearest that stands for itself.
  Shape row;
  for (Index i = 0; i < 9; ++i) row.add(0.5 * i, 0, 0);
  for (Index i = 0; i < 9; ++i) row.face(i, row.add(0.5 * i, 10, 0), row.add(0.5 * i, 10, 10));
  options.weldDistance = 0.5;
  const PreparedSurface joined = prepared(row, options);
  for (Index i = 0; i < 9; ++i) {
    EXPECT_EQ(joined.inputOfVertex[joined.vertexOfInput[i]], i - i % 2) << i;
  }

  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    options.weldDistance = bad;
    EXPECT_EQ(codeOf(prepareSurface(soupOf(ball), options)), "INVALID_OPTION");
  }
  options.weldDistance = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(codeOf(prepareSurface(soupOf(ball), options)), "OK");
  options.weldDistance = 1e300;
  EXPECT_EQ(codeOf(prepareSurface(soupOf(ball), options)), "EMPTY_MESH");
}

TEST(Prepare, DropsUnusedVerticesThatLieNowhere) {
  const PreparedSurface plain = prepared(tetrahedron());
  for (const double nowhere : {std::numeric_limits<double>::quiet_NaN(),
                               -std::numeric_limits<double>::infinity(), 1e308}) {
    TriangleSoup soup = soupOf(tetrahedron());
    soup.positions.insert(soup.positions.end(), {0, nowhere, 0});
    PrepareOptions options;
    options.weldDistance = 1e-3;
    for (const PrepareOptions& how : {PrepareOptions{}, options}) {
      const auto out = prepareSurface(soup, how);
      ASSERT_TRUE(out.ok()) << out.error().message;
      EXPECT_EQ(out.value().report.unreferencedVertices, 1u);
      EXPECT_EQ(out.value().vertexOfInput[4], kNoIndex);
      EXPECT_EQ(out.value().mesh.area(), plain.mesh.area());
    }
  }
}

TEST(Prepare, DropsFacesThatRepeatAVertex) {
  Shape shape = tetrahedron();
  shape.add(7, 7, 7);
  shape.add(8, 8, 8);
  shape.face(0, 0, 1);
  shape.face(4, 5, 4);
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.degenerateFaces, 2u);
  EXPECT_EQ(out.report.unreferencedVertices, 2u);
  EXPECT_EQ(out.mesh.faceCount(), 4u);
  EXPECT_EQ(out.vertexOfInput[5], kNoIndex);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(shape, out);
}

TEST(Prepare, APoleOfRoundingErrorsIsOnePoint) {
  // A globe whose poles are rings of vertices at sin π · r.
  const Index around = 12, along = 8;
  Shape shape;
  for (Index j = 0; j <= along; ++j) {
    const double latitude = M_PI * j / along;
    for (Index i = 0; i < around; ++i) {
      const double longitude = 2 * M_PI * i / around;
      shape.add(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                std::cos(latitude));
    }
  }
  for (Index j = 0; j < along; ++j) {
    for (Index i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around;
      shape.face(a, a + around, b + around);
      shape.face(a, b + around, b);
    }
  }
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  EXPECT_EQ(out.mesh.componentCount(), 1u);
  EXPECT_EQ(out.mesh.genus(0), 0u);
  EXPECT_EQ(out.mesh.vertexCount(), around * (along - 1) + 2);
  expectSound(shape, out);
}

TEST(Prepare, ANeedleThatClosesTheSurfaceIsFlipped) {
  // A cube one edge of which has a vertex in the middle on one side only; a face without area lies
  // between.
  Shape shape;
  addCube(shape, 0, 0, 0);
  const Index middle = shape.add(0.5, 0, 0);
  // Face 1 (0, 3, 1) of the floor becomes (0, 3, m) and (m, 3, 1); the needle is (0, m, 1).
  shape.triangles[3] = 0;
  shape.triangles[4] = 3;
  shape.triangles[5] = middle;
  shape.face(middle, 3, 1);
  shape.face(0, middle, 1);
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.flippedFaces, 1u);
  EXPECT_EQ(out.report.degenerateFaces, 0u);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  EXPECT_EQ(out.mesh.faceCount(), 14u);
  EXPECT_NEAR(out.mesh.area(), 6, 1e-12);
  EXPECT_NEAR(sixfoldVolume(out.mesh), 6, 1e-12);
  expectSound(shape, out);
}

TEST(Prepare, ARowOfNeedlesComesApart) {
  // Many points lie on the edge, in any triangulation of the flat polygon between.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Shape shape;
    addCube(shape, 0, 0, 0);
    std::vector<Index> row{0};
    const Index points = 2 + random.below(9);
    for (Index i = 1; i <= points; ++i) row.push_back(shape.add(double(i) / (points + 1), 0, 0));
    row.push_back(1);
    shape.triangles[3] = 0;
    shape.triangles[4] = 3;
    shape.triangles[5] = row[1];
    for (std::size_t i = 1; i + 1 < row.size(); ++i) shape.face(row[i], 3, row[i + 1]);
    for (std::vector<Index> rest = row; rest.size() > 2;) {
      const auto i = static_cast<std::ptrdiff_t>(1 + random.below(Index(rest.size() - 2)));
      shape.face(rest[i - 1], rest[i], rest[i + 1]);
      rest.erase(rest.begin() + i);
    }
    const PreparedSurface out = prepared(shape);
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    EXPECT_NEAR(out.mesh.area(), 6, 1e-12);
    EXPECT_NEAR(sixfoldVolume(out.mesh), 6, 1e-12);
    expectSound(shape, out);
  }
}

TEST(Prepare, ANeedleThatClosesNothingIsDropped) {
  Shape shape = cubesAt({{0, 0, 0}});
  shape.add(2, 0, 0);
  shape.face(0, 1, 8);  // along an edge and beyond
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.degenerateFaces, 1u);
  EXPECT_EQ(out.mesh.faceCount(), 12u);
  EXPECT_EQ(out.report.unreferencedVertices, 1u);
  expectSound(shape, out);
}

TEST(Prepare, CopiesOfFacesAreDropped) {
  Shape twice = icosphere(1);
  const std::size_t count = twice.triangles.size();
  for (std::size_t i = 0; i < count / 2; ++i) twice.triangles.push_back(twice.triangles[i]);
  for (std::size_t i = 0; i < 9; ++i) twice.triangles.push_back(twice.triangles[i]);
  const PreparedSurface out = prepared(twice);
  EXPECT_EQ(out.report.duplicateFaces, count / 6 + 3);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(twice, out);
}

TEST(Prepare, ADoubleSidedSheetIsOneSheet) {
  // Every face twice, back and front.
  Shape shape;
  for (Index i = 0; i < 9; ++i) shape.add(i % 3, i / 3, 0);
  for (const Index a : {0u, 1u, 3u, 4u}) {
    shape.face(a, a + 1, a + 4);
    shape.face(a, a + 4, a + 3);
  }
  const std::vector<Index> front = shape.triangles;
  for (std::size_t i = 0; i < front.size(); i += 3) {
    shape.face(front[i], front[i + 2], front[i + 1]);
  }
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.duplicateFaces, 8u);
  EXPECT_EQ(out.mesh.faceCount(), 8u);
  EXPECT_EQ(out.report.boundaryCurves, 1u);
  EXPECT_EQ(arraysOf(out.mesh).triangles, front);
  expectSound(shape, out);
  // A part of it is given a third time.
  shape.triangles.insert(shape.triangles.end(), front.begin(), front.begin() + 9);
  EXPECT_EQ(prepared(shape).mesh.faceCount(), 8u);
  // A closed surface inside out as well.
  Shape ball = icosphere(1);
  const std::size_t faces = ball.triangles.size() / 3;
  ball.triangles.insert(ball.triangles.end(), ball.triangles.begin(), ball.triangles.end());
  for (std::size_t f = faces; f < 2 * faces; ++f) turnOver(ball, f);
  EXPECT_EQ(prepared(ball).mesh.faceCount(), faces);
  EXPECT_EQ(prepared(ball).report.boundaryCurves, 0u);
}

TEST(Prepare, SolidsThatShareAPartitionStayWhole) {
  // Two cubes face to face, three in an L, eight in a block.
  for (const auto& places :
       {std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}},
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}}) {
    const Shape shape = cubesAt(places);
    const PreparedSurface out = prepared(shape);
    EXPECT_EQ(out.report.boundaryCurves, 0u) << places.size() << " cubes";
    EXPECT_EQ(out.report.components, places.size());
    EXPECT_EQ(out.report.duplicateFaces, 0u);
    for (const SurfacePart& part : out.parts) EXPECT_DOUBLE_EQ(part.area, 6);
    expectSound(shape, out);
  }
}

TEST(Prepare, TurnsTheFewestFaces) {
  const Shape ball = icosphere(2);
  Shape turned = ball;
  Random random(5);
  Index count = 0;
  for (std::size_t f = 0; f < ball.triangles.size() / 3; ++f) {
    if (random() < 0.3) {
      turnOver(turned, f);
      ++count;
    }
  }
  const PreparedSurface out = prepared(turned);
  EXPECT_EQ(out.report.reorientedFaces, count);
  EXPECT_GT(sixfoldVolume(out.mesh), 0);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(turned, out);
  // Inside out as a whole: the input's business.
  Shape inside = ball;
  for (std::size_t f = 0; f < ball.triangles.size() / 3; ++f) turnOver(inside, f);
  EXPECT_EQ(prepared(inside).report.reorientedFaces, 0u);
}

TEST(Prepare, AMoebiusStripIsCutAcross) {
  Shape strip;
  const Index around = 10;
  for (Index i = 0; i < around; ++i) {
    const double u = 2 * M_PI * i / around;
    for (const double s : {-0.3, 0.0, 0.3}) {
      const double rho = 1 + s * std::cos(u / 2);
      strip.add(rho * std::cos(u), rho * std::sin(u), s * std::sin(u / 2));
    }
  }
  for (Index i = 0; i < around; ++i) {
    const auto at = [&](Index k, Index j) { return k < around ? 3 * k + j : 2 - j; };
    for (Index j = 0; j < 2; ++j) {
      strip.face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      strip.face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  const PreparedSurface out = prepared(strip);
  EXPECT_GE(out.report.oneSidedEdges, 2u);
  EXPECT_EQ(out.mesh.componentCount(), 1u);
  EXPECT_EQ(out.mesh.boundaryCount(0), 1u);
  EXPECT_EQ(out.mesh.genus(0), 0u);
  expectSound(strip, out);
}

TEST(Prepare, SolidsThatShareAnEdgeStayWhole) {
  const Shape two = apart(cubesAt({{0, 0, 0}, {1, 1, 0}}));
  Shape inverted = two;
  for (std::size_t f = 12; f < 24; ++f) turnOver(inverted, f);
  for (const Shape& shape : {two, inverted}) {
    const PreparedSurface out = prepared(shape);
    EXPECT_EQ(out.report.nonManifoldEdges, 1u);
    EXPECT_EQ(out.report.addedVertices, 2u);
    EXPECT_EQ(out.report.nonManifoldVertices, 0u);
    EXPECT_EQ(out.report.components, 2u);
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    expectSound(shape, out);
  }
}

TEST(Prepare, ASolidThatTouchesItselfStaysClosed) {
  // A ring of cubes round a hole, two of which meet in an edge only; as one surface: partitions
  // between cubes are left out.
  const Shape ring = cubesAt({{0, 0, 0}, {0, 1, 0}, {1, 1, 1}, {0, 1, 1}, {1, 0, 0}});
  // Drop both faces of every partition.
  std::multiset<PlacedFace> faces;
  const auto place = [&](std::size_t f) {
    PlacedFace face;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = ring.triangles[3 * f + k];
      face[k] = {ring.positions[3 * v], ring.positions[3 * v + 1], ring.positions[3 * v + 2]};
    }
    return placed(face);
  };
  for (std::size_t f = 0; f < ring.triangles.size() / 3; ++f) faces.insert(place(f));
  Shape outside;
  outside.positions = ring.positions;
  for (std::size_t f = 0; f < ring.triangles.size() / 3; ++f) {
    if (faces.count(place(f)) > 1) continue;
    outside.face(ring.triangles[3 * f], ring.triangles[3 * f + 1], ring.triangles[3 * f + 2]);
  }
  EXPECT_GT(prepared(apart(outside)).report.nonManifoldEdges, 0u);
  for (const Shape& shape : {outside, apart(outside)}) {
    const PreparedSurface out = prepared(shape);
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    EXPECT_NEAR(sixfoldVolume(out.mesh), 30, 1e-12);
    expectSound(shape, out);
  }
}

TEST(Prepare, ThreeSheetsAtAnEdgeComeApart) {
  Shape shape;
  const Index a = shape.add(0, 0, 0), b = shape.add(0, 0, 1);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3;
    shape.face(a, b, shape.add(std::cos(angle), std::sin(angle), 0));
  }
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.nonManifoldEdges, 1u);
  EXPECT_EQ(out.report.addedVertices, 4u);
  EXPECT_EQ(out.report.components, 3u);
  expectSound(shape, out);
}

TEST(Prepare, AFinLeavesTheSolidClosed) {
  Shape shape = cubesAt({{0, 0, 0}});
  const Index tip = shape.add(2, 0, 2);
  shape.face(1, 5, tip);  // on the edge from (1,0,0) to (1,0,1)
  const PreparedSurface out = prepared(shape);
  EXPECT_EQ(out.report.nonManifoldEdges, 1u);
  EXPECT_EQ(out.report.components, 2u);
  EXPECT_EQ(out.parts[0].faces, 12u);
  EXPECT_EQ(out.report.boundaryCurves, 1u) << "the fin's";
  EXPECT_LT(out.vertexOfInput[1], 8u) << "most faces are the cube's";
  expectSound(shape, out);
}

TEST(Prepare, PartsThatTouchAtAVertexComeApart) {
  Shape shape = tetrahedron();
  Shape other = tetrahedron();
  for (std::size_t i = 0; i < other.positions.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      other.positions[i + k] = 2 * shape.positions[k] - other.positions[i + k];
    }
  }
  shape = together(shape, other);
  const PreparedSurface out = prepared(apart(shape));
  EXPECT_EQ(out.report.nonManifoldVertices, 1u);
  EXPECT_EQ(out.report.addedVertices, 1u);
  EXPECT_EQ(out.report.weldedVertices, 17u);
  EXPECT_EQ(out.report.components, 2u);
  EXPECT_EQ(out.report.boundaryCurves, 0u);
  expectSound(apart(shape), out);
  // By the file's own numbers they are apart.
  const PreparedSurface whole = prepared(shape);
  EXPECT_EQ(whole.report.weldedVertices, 0u);
  EXPECT_EQ(whole.report.nonManifoldVertices, 0u);
  EXPECT_EQ(whole.report.components, 2u);
  EXPECT_NE(whole.vertexOfInput[0], whole.vertexOfInput[4]);
  expectSound(shape, whole);
}

TEST(Prepare, WhatTheFileClosesStaysClosed) {
  // Two cubes of a grid that overlap, a third one of its own vertices for every side, and a tube
  // without caps that stands on a side.
  const Shape cubes = box(2, 2, 2, 2, 2, 2);
  for (const auto& [x, y, z] : {std::array<double, 3>{1, 1, 1}, {1, 0, 0}, {0, 0, 2}}) {
    const Shape two = together(cubes, shifted(cubes, x, y, z));
    const PreparedSurface out = prepared(two);
    EXPECT_EQ(out.report.components, 2u);
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    EXPECT_EQ(out.report.duplicateFaces, 0u);
    EXPECT_NEAR(out.parts[0].area, 24, 1e-12);
    EXPECT_NEAR(out.parts[1].area, 24, 1e-12);
    expectSound(two, out);
  }
  // Without numbers, what is inside of one cube is closed, and what is inside of both.
  const Shape crossing = together(cubes, shifted(cubes, 1, 1, 1));
  const PreparedSurface nested = prepared(apart(crossing));
  EXPECT_EQ(nested.report.boundaryCurves, 0u);
  ASSERT_EQ(nested.report.components, 2u);
  EXPECT_NEAR(nested.parts[0].area, 42, 1e-12);
  EXPECT_NEAR(nested.parts[1].area, 6, 1e-12);
  expectSound(apart(crossing), nested);
  // Where sides lie in one plane, the inside of both cannot be told; the order of the faces can,
  // with vertices of its own for every corner, as in STL, or for every side, as in flat shading,
  // and with one vertex at each place.
  for (const Shape& cube : {apart(cubes), sidesApart(cubes)}) {
    const Shape pair = together(cube, shifted(cube, 1, 0, 0));
    const Shape three = together(pair, shifted(cube, 0, 1, 0));
    for (const Shape& inOnePlane : {pair, three, oneVertexAtEachPlace(three)}) {
      const PreparedSurface bodies = prepared(inOnePlane);
      EXPECT_EQ(bodies.report.boundaryCurves, 0u);
      EXPECT_EQ(bodies.report.duplicateFaces, 0u);
      ASSERT_EQ(48 * bodies.report.components, inOnePlane.triangles.size() / 3);
      for (const SurfacePart& part : bodies.parts) EXPECT_NEAR(part.area, 24, 1e-12);
      expectSound(inOnePlane, bodies);
    }
  }
  // The second cube open, and then with a seam round every side.
  for (const bool isOpen : {true, false}) {
    Shape second = shifted(cubes, 1, 1, 1);
    if (isOpen) second.triangles.resize(second.triangles.size() - 6);
    const Shape two = together(cubes, isOpen ? second : apart(second));
    const PreparedSurface out = prepared(two);
    EXPECT_EQ(out.parts[0].faces, 48u);
    EXPECT_EQ(out.report.components, 2u);
    EXPECT_EQ(out.report.boundaryCurves, isOpen ? 1u : 0u);
    expectSound(two, out);
  }
  // A body that is there twice is one, and so is a sheet.
  Shape twice = together(cubes, cubes);
  EXPECT_EQ(prepared(twice).report.duplicateFaces, 48u);
  EXPECT_EQ(prepared(twice).report.components, 1u);
  Shape sheet = cubes;
  sheet.triangles.resize(sheet.triangles.size() / 2);
  twice = together(sheet, sheet);
  EXPECT_EQ(prepared(twice).report.duplicateFaces, 24u);
  EXPECT_EQ(prepared(twice).report.boundaryEdges, prepared(sheet).report.boundaryEdges);
  // A tube without caps that stands on a cube, its foot on the cube's edges.
  const Shape tube = shifted(box(1, 1, 1, 1, 1, 1), 1, 1, 2);
  Shape walls;
  walls.positions = tube.positions;
  for (std::size_t i = 0; i < tube.triangles.size(); i += 3) {
    double z = 0;
    for (std::size_t k = 0; k < 3; ++k) z += tube.positions[3 * tube.triangles[i + k] + 2];
    if (z == 6 || z == 9) continue;
    walls.face(tube.triangles[i], tube.triangles[i + 1], tube.triangles[i + 2]);
  }
  const Shape on = together(box(3, 3, 2, 3, 3, 2), walls);
  const PreparedSurface out = prepared(on);
  EXPECT_EQ(out.report.components, 2u);
  EXPECT_EQ(out.report.boundaryCurves, 2u);
  EXPECT_NEAR(out.parts[0].area, 42, 1e-12);
  expectSound(on, out);
}

TEST(Prepare, ComponentsCanBeChosen) {
  const Shape shape = cubesAt({{0, 0, 0}, {5, 0, 0}, {9, 0, 0}});
  PrepareOptions options;
  options.components = {2, 0};
  const PreparedSurface out = prepared(shape, options);
  EXPECT_EQ(out.report.components, 3u);
  EXPECT_EQ(out.report.keptComponents, 2u);
  EXPECT_EQ(out.mesh.faceCount(), 24u);
  EXPECT_EQ(out.vertexOfInput[8], kNoIndex);
  EXPECT_EQ(out.vertexOfInput[16], 8u);
  EXPECT_EQ(out.inputOfVertex[8], 16u);
  EXPECT_EQ(out.inputOfFace[12], 24u);
  EXPECT_EQ(out.parts[1].firstFace, 12u);
  options.components = {3};
  EXPECT_EQ(codeOf(prepareSurface(soupOf(shape), options)), "COMPONENT_OUT_OF_RANGE");
}

TEST(Prepare, SliversAndDoubledComponentsAreCounted) {
  // A cube; two far smaller ones, the second a sliver; four faces that lie on each other, and a
  // plate that is thin, but has two sides.
  Shape shape = cubesAt({{0, 0, 0}});
  shape = together(shape, moved(cubesAt({{1500, 0, 0}}), 2e-3, 0, 0));
  shape = together(shape, moved(cubesAt({{50'000, 0, 0}}), 1e-4, 0, 0));
  shape = together(shape, {{6, 0, 0, 7, 0, 0, 6.3, 0.01, 0, 6.5, 0.0033, 0},
                           {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}});
  shape = together(shape, moved(box(1, 1, 1e-3, 1, 1, 1), 1, 0, 9));
  const PreparedSurface all = prepared(shape);
  EXPECT_EQ(all.report.components, 5u);
  EXPECT_EQ(all.report.sliverComponents, 1u);
  EXPECT_EQ(all.report.doubledComponents, 1u);
  EXPECT_EQ(all.report.keptComponents, 5u) << "nothing is left out unless it is asked for";

  PrepareOptions options;
  options.minComponent = 1e-7;
  EXPECT_EQ(prepared(shape, options).report.keptComponents, 4u);
  options.minComponent = 0.01;
  const PreparedSurface some = prepared(shape, options);
  EXPECT_EQ(some.report.keptComponents, 2u);
  EXPECT_EQ(some.report.components, 5u);
  EXPECT_EQ(some.vertexOfInput[8], kNoIndex);
  options.minComponent = 1;
  EXPECT_EQ(prepared(shape, options).report.keptComponents, 1u);
  options.components = {1};
  EXPECT_EQ(codeOf(prepareSurface(soupOf(shape), options)), "EMPTY_MESH");
  options.components = {};
  for (const double share : {-1e-9, 1.5, std::nan("")}) {
    options.minComponent = share;
    EXPECT_EQ(codeOf(prepareSurface(soupOf(shape), options)), "INVALID_OPTION") << share;
  }
  // An open sheet has no inside, and is no doubled one.
  EXPECT_EQ(prepared({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}}).report.doubledComponents, 0u);
}

TEST(Prepare, HolesCanBeClosed) {
  PrepareOptions options;
  options.closeHoles = true;
  // A box without one side, and a tube without caps: flat fillings of known area.
  Shape open = box(1, 2, 3, 3, 3, 3);
  std::vector<Index> kept;
  for (std::size_t i = 0; i < open.triangles.size(); i += 3) {
    const auto z = [&](std::size_t k) { return open.positions[3 * open.triangles[i + k] + 2]; };
    if (z(0) + z(1) + z(2) == 9) continue;
    kept.insert(kept.end(), open.triangles.begin() + static_cast<std::ptrdiff_t>(i),
                open.triangles.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  open.triangles = kept;
  const PreparedSurface lid = prepared(open, options);
  ASSERT_EQ(lid.report.closedHoles, 1u);
  EXPECT_EQ(lid.report.boundaryCurves, 0u);
  EXPECT_EQ(lid.report.holes[0].edges, 12u);
  EXPECT_NEAR(lid.report.holes[0].area, 2, 1e-12);
  EXPECT_NEAR(lid.report.holes[0].perimeter, 6, 1e-12);
  EXPECT_EQ(open.positions[3 * lid.report.holes[0].vertex + 2], 3);
  EXPECT_NEAR(sixfoldVolume(lid.mesh), 36, 1e-12);
  EXPECT_EQ(lid.inputOfFace.back(), kNoIndex);
  expectSound(open, lid);

  for (const Index sides : {3u, 7u, 200u}) {  // the last by fans
    Shape tube = prism(regularPolygon(sides, 1), 2, 2);
    tube.triangles.resize(tube.triangles.size() - std::size_t{2} * sides * 3);
    const PreparedSurface out = prepared(tube, options);
    EXPECT_EQ(out.report.closedHoles, 2u);
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    EXPECT_EQ(out.mesh.genus(0), 0u);
    const double area = sides / (4 * std::tan(M_PI / sides));
    EXPECT_NEAR(out.report.holes[1].area / area, 1, 1e-9);
    EXPECT_NEAR(sixfoldVolume(out.mesh) / (12 * area), 1, 1e-9);
    EXPECT_EQ(out.inputOfVertex.back() == kNoIndex, sides == 200u);
    expectConsistent(soupOf(tube), out);
  }

  // Any surface with holes: closed, or what is left is said.
  for (std::uint64_t seed = 1; seed < 2000; seed += 2) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Shape shape = gluedSurface(seed);
    const auto result = prepareSurface(soupOf(shape), options);
    ASSERT_TRUE(result.ok()) << result.error().message;
    expectConsistent(soupOf(shape), result.value());
    EXPECT_EQ(result.value().report.holes.size(), result.value().report.closedHoles);
  }
}

/// A tetrahedron with a corner of three right angles, every facet with vertices of its own, the
/// last one with other numbers.
Shape crackedTetrahedron(double length, double other) {
  Shape shape = {{0, 0, 0, length, 0, 0, 0, length, 0, 0, 0, length}, {0, 2, 1, 0, 1, 3, 0, 3, 2}};
  shape.face(shape.add(other, 0, 0), shape.add(0, other, 0), shape.add(0, 0, other));
  return shape;
}

TEST(Prepare, CracksAreCountedAndSewn) {
  // One rounding, and the six digits of a text.
  for (const double other : {0.30000000000000004, 0.300001}) {
    const Shape shape = crackedTetrahedron(0.3, other);
    const PreparedSurface open = prepared(shape);
    EXPECT_EQ(open.report.components, 2u);
    EXPECT_EQ(open.report.crackVertices, 3u);
    EXPECT_EQ(open.report.tJunctions, 0u);
    EXPECT_GE(open.report.crackWidth, other - 0.3);
    EXPECT_LE(open.report.crackWidth, 1.1 * (other - 0.3));
    PrepareOptions weld, fill;
    weld.weldDistance = open.report.crackWidth;
    fill.closeHoles = true;
    for (const PrepareOptions& options : {weld, fill}) {
      const PreparedSurface closed = prepared(shape, options);
      EXPECT_EQ(closed.mesh.faceCount(), 4u);
      EXPECT_EQ(closed.report.boundaryCurves, 0u);
      EXPECT_EQ(closed.report.crackVertices, 0u);
      EXPECT_EQ(closed.report.crackWidth, 0);
      EXPECT_EQ(closed.report.closedHoles, 0u);
      EXPECT_NEAR(closed.mesh.area(), 0.21294228634059946, 1e-6);
      expectSound(shape, closed);
    }
  }
  EXPECT_EQ(prepared(crackedTetrahedron(0.3, 0.30000000000000004)).report.crackWidth, 5.6e-17);
  EXPECT_EQ(prepared(crackedTetrahedron(0.3, 0.3004)).report.crackVertices, 0u) << "a gap";
  EXPECT_EQ(prepared(tetrahedron()).report.crackVertices, 0u);
}

TEST(Prepare, VerticesWithinEdgesAreCountedAndSewn) {
  // A box without its lid, and a lid with more vertices on its rim, one side of it or all; from
  // both sides where `isMutual`.
  for (const Index cells : {2u, 3u, 7u}) {
    for (const bool isMutual : {false, true}) {
      Shape shape = box(1, 1, 1, isMutual ? 5 : 1, 1, 1), lid = box(1, 1, 1, cells, cells, 1);
      const auto part = [](Shape& of, bool isLid) {
        const std::vector<Index> all = std::exchange(of.triangles, {});
        for (std::size_t i = 0; i < all.size(); i += 3) {
          double z = 0;
          for (std::size_t k = 0; k < 3; ++k) z += of.positions[3 * all[i + k] + 2];
          if ((z == 3) == isLid) of.face(all[i], all[i + 1], all[i + 2]);
        }
      };
      part(shape, false);
      part(lid, true);
      shape = together(shape, lid);
      const PreparedSurface open = prepared(shape);
      const Index count = 4 * (cells - 1) + (isMutual ? 8 : 0);
      EXPECT_EQ(open.report.tJunctions, count);
      EXPECT_EQ(open.report.crackVertices, 0u);
      EXPECT_GT(open.report.crackWidth, 0);
      EXPECT_LT(open.report.crackWidth, 1e-11);
      PrepareOptions weld, fill;
      weld.weldDistance = open.report.crackWidth;
      fill.closeHoles = true;
      for (const PrepareOptions& options : {weld, fill}) {
        const PreparedSurface closed = prepared(shape, options);
        EXPECT_EQ(closed.report.addedFaces, count);
        EXPECT_EQ(closed.report.boundaryCurves, 0u);
        EXPECT_EQ(closed.report.components, 1u);
        EXPECT_EQ(closed.report.tJunctions, 0u);
        EXPECT_NEAR(closed.mesh.area(), 6, 1e-12);
        EXPECT_NEAR(sixfoldVolume(closed.mesh), 6, 1e-12);
        expectSound(shape, closed);
      }
    }
  }
}

TEST(Prepare, NoHoleIsFilledOverAFace) {
  PrepareOptions options;
  options.closeHoles = true;
  // Flat sheets: a square, a ring round a hole, a disc whose rim is filled by a fan.
  Shape sheet = box(3, 3, 1, 3, 3, 1);
  const std::vector<Index> all = std::exchange(sheet.triangles, {});
  Shape ring = sheet, foot = sheet;
  for (std::size_t i = 0; i < all.size(); i += 3) {
    double x = 0, y = 0, z = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      x += sheet.positions[3 * all[i + k]] / 3;
      y += sheet.positions[3 * all[i + k] + 1] / 3;
      z += sheet.positions[3 * all[i + k] + 2];
    }
    const bool isMiddle = x > 1 && x < 2 && y > 1 && y < 2;
    if (z == 0) sheet.face(all[i], all[i + 1], all[i + 2]);
    if (z == 0 && !isMiddle) ring.face(all[i], all[i + 1], all[i + 2]);
    if (z != 0) foot.face(all[i], all[i + 1], all[i + 2]);
  }
  const PreparedSurface flat = prepared(sheet, options);
  EXPECT_EQ(flat.report.closedHoles, 0u);
  EXPECT_EQ(flat.report.boundaryCurves, 1u);
  EXPECT_NEAR(flat.mesh.area(), 9, 1e-12);
  const PreparedSurface filled = prepared(ring, options);
  EXPECT_EQ(filled.report.closedHoles, 1u);
  EXPECT_EQ(filled.report.boundaryCurves, 1u);
  EXPECT_NEAR(filled.mesh.area(), 9, 1e-12);
  Shape disc = prism(regularPolygon(200, 1), 2, 2);
  const std::vector<Index> caps(disc.triangles.end() - 3 * 200, disc.triangles.end());
  disc.triangles = caps;
  EXPECT_EQ(prepared(disc, options).report.closedHoles, 0u);
  // A box without a bottom on a table is closed all the same: the faces are turned against each
  // other.
  const Index first = foot.vertexCount();
  for (const int i : {0, 1, 3, 2}) foot.add(i % 2 == 0 ? -9 : 9, i < 2 ? -9 : 9, 0);
  foot.face(first, first + 1, first + 2);
  foot.face(first, first + 2, first + 3);
  const PreparedSurface onTable = prepared(foot, options);
  EXPECT_EQ(onTable.report.closedHoles, 1u);
  EXPECT_NEAR(onTable.mesh.area(), 30 + 324, 1e-12);
}

TEST(Prepare, SaysWhatIsWrong) {
  EXPECT_EQ(codeOf(prepareSurface({})), "EMPTY_MESH");
  Shape flat;
  for (Index i = 0; i < 6; ++i) flat.add(i, 2 * i, 0);
  flat.face(0, 1, 2);
  flat.face(3, 4, 5);
  const auto nothing = prepareSurface(soupOf(flat));
  EXPECT_EQ(codeOf(nothing), "EMPTY_MESH");
  EXPECT_EQ(nothing.error().message, "all 2 faces have no area");
  TriangleSoup soup = soupOf(tetrahedron());
  soup.triangles[7] = 4;
  EXPECT_EQ(codeOf(prepareSurface(soup)), "INDEX_OUT_OF_RANGE");
  EXPECT_EQ(prepareSurface(soup).error().element, 2);
  soup = soupOf(tetrahedron());
  soup.positions[5] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(codeOf(prepareSurface(soup)), "NON_FINITE_POSITION");
  EXPECT_EQ(prepareSurface(soup).error().element, 1);
  EXPECT_EQ(prepareSurface(soup).error().message,
            "vertex 1 of face 0 has a coordinate that is not a finite number");
  soup.positions[5] = 1e308;
  EXPECT_EQ(codeOf(prepareSurface(soup)), "LIMIT_EXCEEDED");
  EXPECT_EQ(prepareSurface(soup).error().element, 1);
  soup.positions.pop_back();
  EXPECT_EQ(codeOf(prepareSurface(soup)), "EMPTY_MESH");
  const std::atomic<bool> stop{true};
  ExecutionContext context;
  context.cancel = &stop;
  EXPECT_EQ(codeOf(prepareSurface(soupOf(tetrahedron()), {}, context)), "CANCELLED");
}

TEST(Prepare, ProgressEndsAtOne) {
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  ASSERT_TRUE(prepareSurface(soupOf(icosphere(3)), {}, context).ok());
  EXPECT_EQ(last, 1);
}

// --- Any triangles -------------------------------------------------------------------------------

TEST(Prepare, AnyTrianglesBecomeASurface) {
  std::size_t surfaces = 0, flips = 0, oneSided = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Shape shape = seed % 2 == 0 ? randomSoup(seed) : gluedSurface(seed);
    const auto result = prepareSurface(soupOf(shape));
    if (!result) {
      EXPECT_EQ(codeOf(result), "EMPTY_MESH") << result.error().message;
      continue;
    }
    const PreparedSurface& out = result.value();
    ++surfaces;
    flips += out.report.flippedFaces > 0 ? 1 : 0;
    oneSided += out.report.oneSidedEdges > 0 ? 1 : 0;
    expectConsistent(soupOf(shape), out);
    if (out.report.flippedFaces == 0) expectFacesOfTheInput(soupOf(shape), out);
    expectPreparedOnceIsEnough(out);
    if (HasFailure()) return;
  }
  EXPECT_GT(surfaces, 3700u);
  EXPECT_GT(flips, 50u);
  EXPECT_GT(oneSided, 0u);
}

TEST(Prepare, ClosedSurfacesInAnyDisguiseStayWhole) {
  // Corners apart, faces turned, copied and shuffled, with faces that are none in between.
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shapes[] = {plate(2), torus(3, 1, 9, 5), icosphere(1), box(1, 2, 3, 2, 3, 4)};
    const Shape& shape = shapes[seed % 4];
    std::vector<Index> number;
    const Shape source = relabelled(shape, seed, number);
    Shape soup;
    for (std::size_t f = 0; f < source.triangles.size() / 3; ++f) {
      for (int copies = random() < 0.2 ? 2 : 1; copies > 0; --copies) {
        Index v[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const double* p = &source.positions[3 * std::size_t{source.triangles[3 * f + k]}];
          v[k] = soup.add(p[0], p[1], p[2]);
        }
        random() < 0.3 ? soup.face(v[0], v[2], v[1]) : soup.face(v[0], v[1], v[2]);
        if (random() < 0.1) soup.face(v[0], v[0], v[1]);
      }
    }
    const PreparedSurface out = prepared(soup);
    EXPECT_EQ(out.mesh.faceCount(), shape.triangles.size() / 3);
    EXPECT_EQ(out.mesh.vertexCount(), shape.vertexCount());
    EXPECT_EQ(out.report.boundaryCurves, 0u);
    EXPECT_EQ(out.mesh.genus(0), shape.mesh().genus(0));
    EXPECT_NEAR(std::fabs(sixfoldVolume(out.mesh)), sixfoldVolume(shape.mesh()), 1e-9);
    expectConsistent(soupOf(soup), out);
    expectPreparedOnceIsEnough(out);
  }
}

}  // namespace
}  // namespace girth::test
