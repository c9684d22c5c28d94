// Makes a torus as two arrays, and prints the loop at one of its vertices, point by point. Needs
// the core library only: no files are read or written.
#include <girth/girth.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

constexpr girth::Index kAround = 48, kAcross = 16;

/// Three coordinates a vertex. The ring has radius 2, its tube radius 0.5.
std::vector<double> torusPositions() {
  std::vector<double> positions;
  for (girth::Index i = 0; i < kAround; ++i) {
    for (girth::Index j = 0; j < kAcross; ++j) {
      const double u = 2 * std::numbers::pi * i / kAround, v = 2 * std::numbers::pi * j / kAcross;
      const double ring = 2 + 0.5 * std::cos(v);
      positions.insert(positions.end(),
                       {ring * std::cos(u), ring * std::sin(u), 0.5 * std::sin(v)});
    }
  }
  return positions;
}

/// Three vertices a triangle, counter-clockwise seen from outside.
std::vector<girth::Index> torusTriangles() {
  std::vector<girth::Index> triangles;
  for (girth::Index i = 0; i < kAround; ++i) {
    for (girth::Index j = 0; j < kAcross; ++j) {
      const girth::Index i2 = (i + 1) % kAround, j2 = (j + 1) % kAcross;
      const girth::Index a = i * kAcross + j, b = i2 * kAcross + j, c = i2 * kAcross + j2,
                         d = i * kAcross + j2;
      triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
  }
  return triangles;
}

}  // namespace

int main() {
  // Closed surfaces are expected by default. One with open edges is taken with
  // girth::OpenEdges::Boundary; arrays that are not clean yet go through girth::prepareSurface.
  const auto mesh = girth::SurfaceMesh::fromArrays(torusPositions(), torusTriangles());
  if (!mesh) {
    std::fprintf(stderr, "%s; %s\n", mesh.error().message.c_str(), mesh.error().hint.c_str());
    return 1;
  }
  const auto loop = girth::girthLoop(mesh.value(), girth::Vertex(0));
  if (!loop) {
    std::fprintf(stderr, "%s; %s\n", loop.error().message.c_str(), loop.error().hint.c_str());
    return 1;
  }
  // Around the tube: near 2 * pi * 0.5, a little less as the tube is a polygon of 16 sides.
  std::printf("length %g\n", loop.value().length);
  for (const girth::Vec3& point : girth::polyline(mesh.value(), loop.value())) {
    std::printf("%g %g %g\n", point.x, point.y, point.z);
  }
  return 0;
}
