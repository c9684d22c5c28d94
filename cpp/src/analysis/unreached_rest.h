// The rest that a disk growing from a vertex has not reached yet, and how it falls apart.
#pragma once

#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// Where the main part of the rest loses a part.
struct RestSplit {
  Vertex vertex;    ///< reached at that moment
  double depth{0};  ///< how much higher the part's highest vertex is; infinite with a boundary
};

/// The rest {x: height(x) ≥ t} of a surface as t rises from the source, by the values at vertices
/// and along edges. Its main part is what has no other part split from it that is deeper.
struct UnreachedRest {
  /// For each vertex the height at which its part is split from the main part; infinite where it
  /// lies in the main part until it is reached itself.
  std::vector<double> leaves;
  /// Where the main part loses others, in rising order of height.
  std::vector<RestSplit> splits;
  /// The first vertex of the main part at which the disk meets itself without dividing the rest:
  /// round a handle. None on genus 0.
  Vertex handle;
  /// The first vertex of the main part on a boundary; none where there is none.
  Vertex boundary;
  /// The highest vertex of the main part.
  Vertex last;
};

/// The rest as the disk grows from `source`, the lowest vertex. `heights`: one finite value for
/// each vertex of its component; of other components they are infinite. Where heights are equal,
/// the vertex with the lower number counts as lower. O(n log n).
UnreachedRest unreachedRest(const SurfaceMesh& mesh, std::span<const double> heights,
                            Vertex source);

}  // namespace girth
