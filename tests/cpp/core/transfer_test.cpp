// Values from one mesh to another: a carried girth jumps only where it jumped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "girth/transfer.h"
#include "mesh/vector.h"

namespace girth {
namespace {

/// A flat square of `steps` × `steps` pairs of triangles with a side of `side` round the origin,
/// turned by an angle.
SurfaceMesh square(int steps, double side, double angle) {
  std::vector<double> positions;
  std::vector<Index> faces;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; k <= steps; ++k) {
      const double x = side * (i - steps / 2.0) / steps, y = side * (k - steps / 2.0) / steps;
      positions.insert(positions.end(), {x * std::cos(angle) - y * std::sin(angle),
                                         x * std::sin(angle) + y * std::cos(angle), 0});
    }
  }
  const auto at = [&](int i, int k) { return static_cast<Index>(i * (steps + 1) + k); };
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      faces.insert(faces.end(), {at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      faces.insert(faces.end(), {at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return SurfaceMesh::fromArrays(positions, faces, OpenEdges::Boundary).value();
}

/// As a girth grows towards the end of a limb, by twice the distance; and beyond x = 1.25 it is
/// larger by a jump.
double girthAt(const Vec3& p) { return 2 * std::hypot(p.x, p.y) + (p.x > 1.25 ? 9 : 0); }

TEST(CarriedBack, isSteeperOnlyWhereItJumps) {
  const SurfaceMesh few = square(10, 10, 0), many = square(60, 5, 0.4);
  std::vector<double> girth;
  for (const Vertex v : few.vertices()) girth.push_back(girthAt(few.position(v)));
  const std::vector<SurfacePoint> places = nearestPoints(few, many);
  const std::vector<double> plain = interpolated(few, girth, places, 2);
  const std::vector<double> carried = carriedBack(few, girth, many, places);

  const auto risesBy = [&](const std::vector<double>& values, Index h, double slope) {
    const Halfedge edge(h);
    return std::fabs(values[many.to(edge)] - values[many.from(edge)]) > slope * many.length(edge);
  };
  int nearly = 0, jumps = 0, kept = 0;
  for (Index h = 0; h < many.halfedgeCount(); ++h) {
    if (!risesBy(plain, h, 3)) {
      nearly += risesBy(plain, h, 2) ? 1 : 0;
      EXPECT_FALSE(risesBy(carried, h, 2)) << h;
    } else if (risesBy(plain, h, 6)) {
      ++jumps;
      kept += risesBy(carried, h, 6) ? 1 : 0;
    }
  }
  EXPECT_GT(nearly, 100);
  EXPECT_GT(jumps, 50);
  // But beside a corner of its line, where values step up little by little.
  EXPECT_GT(kept, 0.95 * jumps);
  // Only lowered, and by less than a face of the few is off by beside the origin.
  for (Index v = 0; v < many.vertexCount(); ++v) {
    EXPECT_LE(carried[v], plain[v]);
    EXPECT_GT(carried[v], plain[v] - 0.5);
  }
}

TEST(CarriedBack, whatIsNotSteepAndWhatHasNoValueStay) {
  const SurfaceMesh few = square(10, 10, 0), many = square(60, 5, 0.4);
  std::vector<double> girth;
  for (const Vertex v : few.vertices()) girth.push_back(few.position(v).x);
  girth[60] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<SurfacePoint> places = nearestPoints(few, many);
  const std::vector<double> plain = interpolated(few, girth, places, 2);
  const std::vector<double> carried = carriedBack(few, girth, many, places);
  const auto without = [](double value) { return std::isnan(value); };
  EXPECT_GT(std::count_if(carried.begin(), carried.end(), without), 10);
  for (const Vertex v : many.vertices()) {
    EXPECT_EQ(without(carried[v]), without(plain[v]));
    // Beside it values are those of the nearest corner.
    if (norm(many.position(v)) < 1.5) continue;
    EXPECT_EQ(carried[v], plain[v]) << Index{v};
  }
}

}  // namespace
}  // namespace girth
