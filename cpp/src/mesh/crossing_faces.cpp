#include "mesh/crossing_faces.h"

#include <algorithm>
#include <cmath>

#include "mesh/orientation.h"
#include "mesh/vector.h"

namespace girth {
namespace {

/// A point beside a plane: of points in the plane, `orientation` with it is their turn.
Vec3 beside(const Triangle3& plane) {
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  const Vec3 size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  const double reach = 1 + std::fabs(plane[0].x) + std::fabs(plane[0].y) + std::fabs(plane[0].z);
  Vec3 point = plane[0];
  if (size.x >= size.y && size.x >= size.z) {
    point.x += reach;
  } else if (size.y >= size.z) {
    point.y += reach;
  } else {
    point.z += reach;
  }
  return point;
}

/// Whether two segments of one plane meet.
bool segmentsMeet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& off) {
  const int pa = orientation(p, q, off, a), pb = orientation(p, q, off, b);
  const int ap = orientation(a, b, off, p), aq = orientation(a, b, off, q);
  if (pa * pb > 0 || ap * aq > 0) return false;
  if (pa != 0 || pb != 0) return true;
  // On one line.
  const auto haveCommon = [](double p0, double p1, double a0, double a1) {
    return std::max(std::min(p0, p1), std::min(a0, a1)) <=
           std::min(std::max(p0, p1), std::max(a0, a1));
  };
  return haveCommon(p.x, q.x, a.x, b.x) && haveCommon(p.y, q.y, a.y, b.y) &&
         haveCommon(p.z, q.z, a.z, b.z);
}

bool containsInPlane(const Triangle3& t, const Vec3& p, const Vec3& off) {
  const int x = orientation(t[0], t[1], off, p), y = orientation(t[1], t[2], off, p),
            z = orientation(t[2], t[0], off, p);
  return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

/// Whether a segment and a triangle have a point in common.
bool segmentMeets(const Vec3& p, const Vec3& q, const Triangle3& t) {
  const int atP = orientation(t[0], t[1], t[2], p), atQ = orientation(t[0], t[1], t[2], q);
  if (atP * atQ > 0) return false;
  if (atP == 0 && atQ == 0) {
    const Vec3 off = beside(t);
    return containsInPlane(t, p, off) || segmentsMeet(p, q, t[0], t[1], off) ||
           segmentsMeet(p, q, t[1], t[2], off) || segmentsMeet(p, q, t[2], t[0], off);
  }
  const int x = orientation(p, q, t[0], t[1]), y = orientation(p, q, t[1], t[2]),
            z = orientation(p, q, t[2], t[0]);
  return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

struct FaceBox {
  Vec3 low, high;
};

FaceBox boxOfFace(const SurfaceMesh& mesh, Face f) {
  const auto corners = mesh.faceVertices(f);
  FaceBox box{mesh.position(corners[0]), mesh.position(corners[0])};
  for (const Vertex v : corners) {
    const Vec3& p = mesh.position(v);
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

bool boxesOverlap(const FaceBox& a, const FaceBox& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

PlacedFace placed(const SurfaceMesh& mesh, Face f) {
  const auto t = mesh.faceVertices(f);
  return {t, {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])}};
}

}  // namespace

bool trianglesMeet(const Triangle3& a, const Triangle3& b, std::size_t shared) {
  if (shared >= 3) return true;
  if (shared == 2) {
    if (orientation(a[0], a[1], a[2], b[2]) != 0) return false;
    const Vec3 off = beside(a);
    return orientation(a[0], a[1], off, a[2]) * orientation(a[0], a[1], off, b[2]) > 0;
  }
  if (shared == 1) return segmentMeets(a[1], a[2], b) || segmentMeets(b[1], b[2], a);
  for (std::size_t i = 0; i < 3; ++i) {
    if (segmentMeets(a[i], a[(i + 1) % 3], b) || segmentMeets(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

bool facesMeet(PlacedFace a, PlacedFace b) {
  // Shared corners first, in the same order.
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (a.vertices[i] != b.vertices[j]) continue;
      std::swap(a.vertices[i], a.vertices[shared]);
      std::swap(a.places[i], a.places[shared]);
      std::swap(b.vertices[j], b.vertices[shared]);
      std::swap(b.places[j], b.places[shared]);
      ++shared;
      break;
    }
  }
  return trianglesMeet(a.places, b.places, shared);
}

std::vector<std::pair<Face, Face>> crossingFaces(const SurfaceMesh& mesh,
                                                 std::span<const Face> faces) {
  std::vector<FaceBox> boxes;
  boxes.reserve(mesh.faceCount());
  double widest = 0;
  for (const Face f : mesh.faces()) {
    boxes.push_back(boxOfFace(mesh, f));
    widest = std::max(widest, boxes.back().high.x - boxes.back().low.x);
  }
  std::vector<Face> order(mesh.faces().begin(), mesh.faces().end());
  std::sort(order.begin(), order.end(),
            [&](Face f, Face g) { return boxes[f].low.x < boxes[g].low.x; });
  std::vector<std::pair<Face, Face>> pairs;
  for (const Face f : faces) {
    auto other = std::lower_bound(order.begin(), order.end(), boxes[f].low.x - widest,
                                  [&](Face g, double x) { return boxes[g].low.x < x; });
    for (; other != order.end() && boxes[*other].low.x <= boxes[f].high.x; ++other) {
      if (*other == f || !boxesOverlap(boxes[f], boxes[*other])) continue;
      if (!facesMeet(placed(mesh, f), placed(mesh, *other))) continue;
      pairs.emplace_back(std::min(f, *other), std::max(f, *other));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace girth
