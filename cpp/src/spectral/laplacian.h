// The Laplace operator of a triangulation, as weights of its edges and areas of its vertices.
#pragma once

#include <vector>

#include "spectral/intrinsic_triangulation.h"

namespace girth::spectral {

/// (L φ)(i) = Σ weight · (φ(i) − φ(j)) over the edges ij at i; M has `areas` on its diagonal.
struct Laplacian {
  struct Edge {
    Index i, j;
    double weight;
  };
  /// Without edges that lead back to their vertex, which have no effect. Two vertices may have
  /// several.
  std::vector<Edge> edges;
  std::vector<double> areas;
};

/// Half the sum of the cotangents opposite to an edge, and mixed Voronoi areas (spectrum.h), in the
/// triangulation's units. O(n).
Laplacian cotangentLaplacian(const IntrinsicTriangulation& triangles, Index vertices);

/// The operator of each component by itself, its vertices in their order.
struct ComponentLaplacian {
  Laplacian laplacian;
  std::vector<Index> vertices;
};
std::vector<ComponentLaplacian> byComponent(Laplacian laplacian, const SurfaceMesh& mesh);

}  // namespace girth::spectral
