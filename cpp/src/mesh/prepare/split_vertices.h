// One copy of a vertex for every fan of faces that is joined round it.
#pragma once

#include <vector>

#include "mesh/prepare/join_faces.h"

namespace girth::prepare {

/// The vertices of a surface.
struct SplitVertices {
  /// For each corner of the faces (by its halfedge), its vertex on the surface.
  std::vector<Index> vertexOfCorner;
  /// The vertex of the input that each comes from: where the input's corners are given, the first
  /// among its own. Copies of one place stand together, in the order of their first faces.
  std::vector<Index> inputOfVertex;
};

/// Copies vertices where several fans meet. Joints in `joined` that would still leave more than one
/// edge between two vertices are cut as well. `inputOfCorner`: the vertex of the input at each
/// corner, or empty.
SplitVertices splitVertices(const WorkingFaces& faces, JoinedFaces& joined,
                            const std::vector<Index>& inputOfCorner, PreparationReport& report);

}  // namespace girth::prepare
