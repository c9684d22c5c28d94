// Which sides of which faces are joined: orientation, and cuts where a surface cannot go on.
#pragma once

#include <vector>

#include "mesh/prepare/working_faces.h"

namespace girth::prepare {

/// Faces turned so that neighbours agree, and the joints between them.
struct JoinedFaces {
  /// For each halfedge the one it is joined to, running the other way; kNoIndex at a boundary.
  std::vector<Index> twin;
  /// The halfedges of the edges where more than two faces met or that were cut as the surface has
  /// one side only; edge by edge.
  std::vector<Index> cut;
  std::vector<Index> cutBegin;  ///< first corner of each edge in `cut`, and the end
};

/// Orients `faces` (turns them over in place) and joins them.
JoinedFaces joinFaces(WorkingFaces& faces, PreparationReport& report);

}  // namespace girth::prepare
