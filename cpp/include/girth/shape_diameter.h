// The shape diameter function: how thick the body under a point of its surface is.
#pragma once

#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/vertex_function.h"

namespace girth {

/// Which rays are sent.
struct ShapeDiameterOptions {
  /// The full opening of the cone of rays, in radians, in (0, π).
  double coneRadians{2.0943951023931953};  // 120°
  /// Rays sent from each vertex, 1 to 10,000.
  unsigned rays{30};
};

/// How thick the body is under each vertex.
struct ShapeDiameterField {
  /// In model units, one for each vertex; NaN where no ray met a wall from inside, or before the
  /// work was cancelled.
  std::vector<double> values;
  /// Vertices that no ray gave a value.
  Index withoutValue{0};
  /// isInsideOut of the surface.
  bool insideOut{false};
  /// False after cancelling.
  bool complete{false};
};

/// The shape diameter of every vertex (Shapira, Shamir and Cohen-Or 2008; Gal, Shamir and Cohen-Or
/// 2007; web/docs/definitions.md, section 4). Rays go from the vertex into the inside, within a
/// cone around the inward normal (the mean of the faces' normals, weighted by their angles at the
/// vertex), to the first wall. A ray that escapes, or that meets the wall from outside, does not
/// count. Lengths more than one standard deviation away from their median are dropped; the value is
/// the mean of the others, each weighted by the inverse of its ray's angle with the axis of the
/// cone.
///
/// The rays are the same for every vertex and every run: number i of n leaves the axis by
/// (i + ½)/n of half the cone's angle, and is turned by i golden angles around it from a fixed
/// direction. So they are denser around the axis, and the value is near the diameter: 1.9 r for a
/// sphere of radius r, 1.05 t for a slab of thickness t.
///
/// The surface may be open. Any number of threads gives the same bits, natively and in WebAssembly.
/// O(n · rays · log n). Errors: USAGE for options out of range.
///
/// \code
/// const auto diameter = girth::shapeDiameter(mesh).value();
/// std::cout << diameter.values[0] << '\n';
/// \endcode
GIRTH_EXPORT Result<ShapeDiameterField> shapeDiameter(const SurfaceMesh& mesh,
                                                      const ShapeDiameterOptions& options = {},
                                                      const ExecutionContext& context = {});

/// The shape diameter, in model units, vertex by vertex. Errors are the same.
GIRTH_EXPORT Result<VertexFunction<double>> shapeDiameterFunction(
    const SurfaceMesh& mesh, const ShapeDiameterOptions& options = {});
/// The mesh must outlive the function: keep it in a variable.
Result<VertexFunction<double>> shapeDiameterFunction(
    const SurfaceMesh&&, const ShapeDiameterOptions& options = {}) = delete;

/// Whether the surface is closed, but encloses a negative volume: its faces look inwards, and what
/// is measured is the space around it. O(n).
GIRTH_EXPORT bool isInsideOut(const SurfaceMesh& mesh);

/// Remarks on the values for people, in sentences: that the surface is inside out, that so
/// many of its vertices have no shape diameter. Empty where there is no remark.
GIRTH_EXPORT std::string shapeDiameterNote(bool insideOut, Index withoutValue, Index vertices);

}  // namespace girth
