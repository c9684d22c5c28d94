// Remeshing: one surface with other triangles, as many as asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The quality that the new triangles are to have.
enum class RemeshMethod : std::uint8_t {
  /// To keep the shape: edges are collapsed where that moves the surface least, by quadrics
  /// (Garland and Heckbert 1997), and vertices put where they fit the planes of the faces best,
  /// beside the surface rather than on it, so that area and girth hardly shrink. Sharp points, on
  /// which loops hang, are kept. Triangles are longer where the surface is bent one way only. It
  /// only removes: where more triangles are wanted than there are, they are made as by Even.
  Fitting,
  /// To be of even size and good shape: isotropic remeshing (Botsch and Kobbelt 2004). Long edges
  /// are split, short ones collapsed, edges flipped for even valences, and vertices moved along the
  /// surface, always back onto the original. Few triangles cut thin parts short.
  Even,
};

/// The wanted mesh.
struct RemeshOptions {
  /// Triangles wanted, from 4 to 100 million.
  Index faces{10'000};
  /// How triangles are made.
  RemeshMethod method{RemeshMethod::Fitting};
};

/// A surface with other triangles.
struct RemeshedSurface {
  /// With numbers of its own.
  SurfaceMesh mesh;
  /// For each vertex the point of the original surface that it lies on, or next to (Fitting).
  std::vector<SurfacePoint> onOriginal;
};

/// Another mesh of the surface. Components, genus and boundary curves stay as they are; boundaries
/// keep to themselves, and so do, where triangles are even, edges sharper than 50° in lines of some
/// length. The number of triangles is met to within 2 %, but where the shape needs more (every
/// component at least 4, every boundary and sharp line its own). Equal inputs always give equal
/// triangles. About 10 µs for each triangle, old and new.
///
/// Errors: INVALID_OPTION (faces), CANCELLED, OUT_OF_MEMORY.
///
/// \code
/// const auto even = girth::remesh(mesh, {500, girth::RemeshMethod::Even}).value();
/// std::cout << even.mesh.faceCount() << " faces\n";
/// \endcode
GIRTH_EXPORT Result<RemeshedSurface> remesh(const SurfaceMesh& mesh, const RemeshOptions& options,
                                            const ExecutionContext& context = {});

}  // namespace girth
