// Cracks: where a boundary nearly coincides with itself, by rounding or by vertices on one side
// only.
#pragma once

#include <span>
#include <vector>

#include "mesh/prepare/working_faces.h"

namespace girth::prepare {

/// Where the edges of one face nearly coincide.
struct Cracks {
  /// A vertex, an earlier one that it nearly coincides with, and how far away that is.
  struct NearVertex {
    Index vertex, earlier;
    double distance;
  };
  /// A vertex that nearly lies within an edge: the halfedge, how far along it, and how far away.
  struct OnEdge {
    Index vertex, halfedge;
    double along, distance;
  };
  std::vector<NearVertex> nearVertices;
  std::vector<OnEdge> onEdges;  ///< each vertex once, at its nearest edge

  /// A distance to weld within that joins all of them: of two digits, rounded up; 0 without any.
  double width(double scale) const;
};

/// Finds cracks among `triangles`: no wider than `distance`, in the units of `positions`. A
/// distance of 0 stands for what rounding may do: a hundred thousandth of the extent, and a tenth
/// of the shortest open edge at a vertex. Vertices at equal positions are no crack. `scale` brings
/// coordinates to a scale near 1. O(n log n) in the open edges.
Cracks findCracks(std::span<const double> positions, std::span<const Index> triangles, double scale,
                  double distance);

/// Divides faces at the vertices that lie within their open edges; with `closeHoles` joins boundary
/// vertices first that nearly coincide. `first` is as in dropCollapsedFaces.
void sewCracks(WorkingFaces& faces, std::vector<Index>& first, const PrepareOptions& options,
               PreparationReport& report);

}  // namespace girth::prepare
