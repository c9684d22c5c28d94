// Faces for boundary curves.
#pragma once

#include <functional>
#include <vector>

#include "girth/prepare_surface.h"

namespace girth::prepare {

/// Faces and vertices that close a surface.
struct HoleFillings {
  std::vector<ClosedHole> holes;  ///< `vertex` is one of the surface
  std::vector<Index> triangles;
  /// Positions of new vertices, numbered on from those of the surface.
  std::vector<double> positions;
};

/// Fills every boundary curve of a surface: one of up to 100 edges with the triangulation of least
/// area (Barequet and Sharir 1995), without new vertices; a longer one, or one for which there is
/// none that stays manifold, with a fan round its middle. A curve for which neither gives faces
/// with area is left. Fillings of several curves may use the same diagonal; with `fansOnly` there
/// are none. Where `isWanted` is given, only curves are filled that consist of wanted halfedges.
HoleFillings fillHoles(const SurfaceMesh& mesh, bool fansOnly = false,
                       const std::function<bool(Halfedge)>& isWanted = {});

}  // namespace girth::prepare
