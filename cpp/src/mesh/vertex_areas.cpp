#include "girth/vertex_areas.h"

namespace girth {

std::vector<double> vertexAreas(const SurfaceMesh& mesh) {
  std::vector<double> areas(mesh.vertexCount(), 0);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const double area = mesh.area(f);
    double square[3];  // of the side opposite to corner k
    for (Index k = 0; k < 3; ++k) {
      const double side = mesh.length(3 * f + (k + 1) % 3);
      square[k] = side * side;
    }
    for (Index k = 0; k < 3; ++k) {
      const double a = square[k], b = square[(k + 1) % 3], c = square[(k + 2) % 3];
      double share;
      if (a > b + c) {
        share = area / 2;
      } else if (b > a + c || c > a + b) {
        share = area / 4;
      } else {
        // (b cot B + c cot C) / 8, with cot B = (a + c − b) / (4 · area).
        share = (b * (a + c - b) + c * (a + b - c)) / (32 * area);
      }
      areas[mesh.from(3 * f + k)] += share;
    }
  }
  return areas;
}

}  // namespace girth
