// The maxima of a field, ranked by how far they rise above their surroundings.
#pragma once

#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// A maximum of a field.
struct PersistentMaximum {
  /// Where it is.
  Vertex vertex;
  /// The field there, in its unit.
  double value{0};
  /// How far one must go down from it, at least, to reach a higher maximum: 0 or more, in the
  /// field's unit. For the highest of a component: how far down to its least value.
  double persistence{0};
  /// The vertex where its surroundings meet those of a higher maximum; none for the highest.
  Vertex saddle;
};

/// All maxima of `values` along the surface's edges, most persistent first: the topological
/// persistence of the connected components of the sets {values ≥ c} (Edelsbrunner, Letscher and
/// Zomorodian 2002). Among equal values the vertex with the lower number counts as higher; maxima
/// that only this makes are left out, but for one of each component. For minima, hand over the
/// negated values. Vertices without a value (NaN) are not part of the surface.
///
/// O(n log n). Errors: USAGE where the values are not as many as the vertices.
///
/// \code
/// const auto extent = girth::geodesicExtent(mesh, girth::DistanceMethod::Exact);
/// for (const auto& maximum : girth::persistentMaxima(mesh, extent.average).value()) {
///   std::cout << maximum.value << ' ' << maximum.persistence << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<std::vector<PersistentMaximum>> persistentMaxima(
    const SurfaceMesh& mesh, std::span<const double> values);

}  // namespace girth
