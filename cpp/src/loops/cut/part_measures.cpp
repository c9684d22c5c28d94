// Measures of a part of a surface that was cut.
#include <limits>

#include "girth/cut_surface.h"

namespace girth {
namespace {

double enclosedVolume(const SurfaceMesh& mesh) {
  if (mesh.boundaryCount(0) > 0) return std::numeric_limits<double>::quiet_NaN();
  double volume = 0;
  const Vec3& o = mesh.position(Vertex(0));
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    const Vec3 &a = mesh.position(corners[0]), &b = mesh.position(corners[1]),
               &c = mesh.position(corners[2]);
    volume += ((a.x - o.x) * ((b.y - o.y) * (c.z - o.z) - (b.z - o.z) * (c.y - o.y)) +
               (a.y - o.y) * ((b.z - o.z) * (c.x - o.x) - (b.x - o.x) * (c.z - o.z)) +
               (a.z - o.z) * ((b.x - o.x) * (c.y - o.y) - (b.y - o.y) * (c.x - o.x))) /
              6;
  }
  return volume;
}

}  // namespace

PartMeasures partMeasures(const SurfaceMesh& part) {
  PartMeasures measures{part.area(), enclosedVolume(part), 0, part.boundaryCount(0)};
  for (Index c = 0; c < part.componentCount(); ++c) measures.genus += part.genus(c);
  return measures;
}

}  // namespace girth
