// Lines across edges of a surface, from face to face.
#pragma once

#include <vector>

#include "girth/tips.h"

namespace girth {

/// Joins crossed edges to lines through the faces: a face with two of them leads from one to the
/// other. Lines end at boundaries, and in faces where one or all three sides are crossed. Each edge
/// belongs to one line. `edges`: one halfedge for each crossed edge; `crossed`: for each halfedge.
std::vector<ContourLine> contourLines(const SurfaceMesh& mesh, const std::vector<Halfedge>& edges,
                                      const std::vector<bool>& crossed);

/// Length of a line, in model units.
double lengthOf(const SurfaceMesh& mesh, const ContourLine& line);

}  // namespace girth
