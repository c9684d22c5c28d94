#include "mesh/remesh/face_checks.h"

#include <algorithm>

#include "mesh/face_shape.h"

namespace girth::remeshing {

namespace {

/// Cosine of the angle that decides whether a face has been turned over by a change.
constexpr double kTurned = 0.2;
/// Heights of a face below this share of its longest side make it thin.
constexpr double kThin = 0.05;

/// The sine of the smallest angle of a triangle.
double leastAngleMeasure(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = norm(b - a), bc = norm(c - b), ca = norm(a - c);
  const double area = norm(cross(b - a, c - a));
  // Opposite to the shortest side.
  const double shortest = std::min({ab, bc, ca});
  const double product = ab * bc * ca;
  return product > 0 ? area * shortest / product : 0;
}

}  // namespace

bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c) { return FaceShape({a, b, c}).hasArea(); }

bool facesAs(const Vec3& before, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 after = cross(b - a, c - a);
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  if (norm(after) < kThin * longest * longest) {
    return norm(after) > norm(before) && dot(before, after) > 0 && hasArea(a, b, c);
  }
  return dot(before, after) > kTurned * norm(before) * norm(after);
}

bool keepsFacing(const ChangingMesh& mesh, Index vertex, const Vec3& place, Index other) {
  bool keeps = true;
  mesh.forEachOutgoing(vertex, [&](Index h) {
    const Index b = mesh.to(h), c = mesh.apex(h);
    if (!keeps || b == other || c == other) return;
    keeps = facesAs(mesh.areaVector(h / 3), place, mesh.position(b), mesh.position(c));
  });
  return keeps;
}

bool flipsSmoothly(const ChangingMesh& mesh, Index h, double cosine) {
  const Index t = mesh.twin(h);
  const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h)),
             &c = mesh.position(mesh.apex(h)), &d = mesh.position(mesh.apex(t));
  const Vec3 normal = mesh.areaVector(h / 3) + mesh.areaVector(t / 3);
  const Vec3 one = cross(b - d, c - d), two = cross(a - c, d - c);
  const double size = norm(normal);
  if (dot(one, normal) < cosine * norm(one) * size ||
      dot(two, normal) < cosine * norm(two) * size) {
    return false;
  }
  return leastAngleMeasure(d, b, c) > 0.05 && leastAngleMeasure(c, a, d) > 0.05;
}

void widenAngles(ChangingMesh& mesh, double cosine, CancellationPoll& poll) {
  constexpr int kMostPasses = 3;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    bool any = false;
    for (Index h = 0; h < mesh.halfedgeCount() && !poll.stopped(); ++h) {
      if (!mesh.isFirstOfEdge(h) || mesh.twin(h) == kNoIndex || !mesh.canFlip(h)) continue;
      const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h)),
                 &c = mesh.position(mesh.apex(h)), &d = mesh.position(mesh.apex(mesh.twin(h)));
      const double before = std::min(leastAngleMeasure(a, b, c), leastAngleMeasure(b, a, d));
      const double after = std::min(leastAngleMeasure(d, b, c), leastAngleMeasure(c, a, d));
      if (after > before * (1 + 1e-6) && flipsSmoothly(mesh, h, cosine)) {
        mesh.flip(h);
        any = true;
      }
    }
    if (!any) return;
  }
}

}  // namespace girth::remeshing
