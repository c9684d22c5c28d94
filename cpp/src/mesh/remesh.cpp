#include "girth/remesh.h"

#include <new>
#include <string>
#include <utility>
#include <vector>

#include "mesh/face_shape.h"
#include "mesh/remesh/isotropic.h"
#include "mesh/remesh/simplify.h"

namespace girth {

namespace {

/// Coordinates with larger exponents, up or down, are brought to a scale near 1 first: squares of
/// areas must neither overflow nor vanish.
constexpr double kLargest = 1e60;

/// A surface made larger or smaller by a power of two.
Result<SurfaceMesh> scaled(const SurfaceMesh& mesh, double scale) {
  std::vector<double> positions;
  std::vector<Index> triangles;
  for (const Vertex v : mesh.vertices()) {
    const Vec3 p = scale * mesh.position(v);
    positions.insert(positions.end(), {p.x, p.y, p.z});
  }
  for (const Halfedge h : mesh.halfedges()) triangles.push_back(mesh.from(h));
  return SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
}

Result<RemeshedSurface> remeshNear(const SurfaceMesh& mesh, const RemeshOptions& options,
                                   const ExecutionContext& context) {
  const bool fits = options.method == RemeshMethod::Fitting && options.faces <= mesh.faceCount();
  return fits ? remeshing::simplify(mesh, options.faces, context)
              : remeshing::remeshEvenly(mesh, options.faces, context);
}

/// Remeshes at a scale near 1.
Result<RemeshedSurface> remeshScaled(const SurfaceMesh& mesh, double scale,
                                     const RemeshOptions& options,
                                     const ExecutionContext& context) {
  const Result<SurfaceMesh> near = scaled(mesh, scale);
  if (!near) return near.error();
  auto out = remeshNear(near.value(), options, context);
  if (!out) return out;
  auto back = scaled(out.value().mesh, 1 / scale);
  if (!back) return back.error();
  return RemeshedSurface{std::move(back).value(), std::move(out.value().onOriginal)};
}

}  // namespace

Result<RemeshedSurface> remesh(const SurfaceMesh& mesh, const RemeshOptions& options,
                               const ExecutionContext& context) {
  constexpr Index kMostFaces = 100'000'000;
  if (options.faces < 4 || options.faces > kMostFaces) {
    return makeError(ErrorCode::InvalidOption, options.faces,
                     std::to_string(options.faces) + " faces are not between 4 and 100 million");
  }
  try {
    const double extent = extentOf(mesh);
    if (extent > kLargest || extent < 1 / kLargest) {
      return remeshScaled(mesh, scaleFor(extent), options, context);
    }
    return remeshNear(mesh, options, context);
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to remesh");
  }
}

}  // namespace girth
