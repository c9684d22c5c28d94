// The faces of a surface divided along curves, before anything is taken apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "girth/cut_surface.h"
#include "mesh/edge_groups.h"

namespace girth::loops {

/// Triangles in which every curve runs along edges.
struct DividedSurface {
  std::vector<SurfacePoint> points;  ///< points by vertex; the vertices of the surface come first
  std::vector<Index> triangles;
  std::vector<Face> faces;  ///< for each triangle the face that it is a piece of
  /// For each halfedge of the triangles the one on its other side; kNoIndex at the boundary.
  std::vector<Index> twins;
  std::vector<bool> isCut;  ///< for each halfedge: a curve runs along it
};

/// The error where cutting is cancelled.
Error cutCancelled();

/// Errors: those of cutSurface.
Result<DividedSurface> divided(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               const ExecutionContext& context = {});

/// For each triangle the number of its part: triangles are of one part where a way leads from one
/// to the other over no cut. Parts are numbered by their first triangles.
std::vector<Index> partsOf(const DividedSurface& surface);

}  // namespace girth::loops
