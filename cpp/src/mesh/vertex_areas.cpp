#include "girth/vertex_areas.h"

#include "mesh/voronoi_share.h"

namespace girth {

std::vector<double> vertexAreas(const SurfaceMesh& mesh) {
  std::vector<double> areas(mesh.vertexCount(), 0);
  for (const Face f : mesh.faces()) {
    const double area = mesh.area(f);
    double square[3];  // squares of the sides opposite to corner k
    for (Index k = 0; k < 3; ++k) {
      const double side = mesh.length(Halfedge(3 * f + (k + 1) % 3));
      square[k] = side * side;
    }
    for (Index k = 0; k < 3; ++k) {
      areas[mesh.from(Halfedge(3 * f + k))] +=
          voronoiShare(area, square[k], square[(k + 1) % 3], square[(k + 2) % 3]);
    }
  }
  return areas;
}

}  // namespace girth
