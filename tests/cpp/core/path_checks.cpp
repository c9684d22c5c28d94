#include "path_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace girth::test {

namespace {

/// The faces that a point belongs to.
std::set<Index> facesOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  std::set<Index> faces;
  switch (point.kind) {
    case SurfacePoint::Kind::InFace:
      faces.insert(point.element);
      break;
    case SurfacePoint::Kind::OnEdge:
      faces.insert(SurfaceMesh::faceOf(Halfedge(point.element)));
      if (const Halfedge twin = mesh.twin(Halfedge(point.element)); twin != kNoIndex) {
        faces.insert(SurfaceMesh::faceOf(twin));
      }
      break;
    case SurfacePoint::Kind::AtVertex: {
      const Halfedge start = mesh.outgoing(Vertex(point.element));
      Index h = start;
      do {
        faces.insert(SurfaceMesh::faceOf(Halfedge(h)));
        h = mesh.twin(SurfaceMesh::previous(Halfedge(h)));
      } while (h != kNoIndex && h != start);
      break;
    }
  }
  return faces;
}

double between(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

void expectShortestPath(const SurfaceMesh& mesh, const GeodesicPath& path, const SurfacePoint& from,
                        const SurfacePoint& to, double distance) {
  const double size = mesh.meanEdgeLength();
  EXPECT_NEAR(path.length, distance, 1e-9 * distance + 1e-12 * size);
  ASSERT_GE(path.points.size(), distance > 0 ? 2u : 1u);
  EXPECT_LE(between(positionOf(mesh, path.points.front()), positionOf(mesh, from)), 1e-12 * size);
  EXPECT_LE(between(positionOf(mesh, path.points.back()), positionOf(mesh, to)), 1e-12 * size);
  double length = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const SurfacePoint &a = path.points[i - 1], &b = path.points[i];
    length += between(positionOf(mesh, a), positionOf(mesh, b));
    const std::set<Index> ofA = facesOf(mesh, a), ofB = facesOf(mesh, b);
    EXPECT_TRUE(std::any_of(ofA.begin(), ofA.end(), [&](Index f) { return ofB.count(f) > 0; }))
        << "points " << i - 1 << " and " << i << " have no face in common";
  }
  EXPECT_NEAR(length, distance, 1e-9 * distance + 1e-12 * size);
}

}  // namespace girth::test
