// Triangles as a file gives them, before anything is known about the surface they make.
#pragma once

#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// Any triangles: corners may repeat, edges may have any number of faces, sides may be turned.
struct TriangleSoup {
  /// x, y, z per input vertex, in model units.
  std::vector<double> positions;
  /// Three input vertices per triangle.
  std::vector<Index> triangles;
};

}  // namespace girth
