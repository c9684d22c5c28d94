// Numbers of vertices as callers give them.
#pragma once

#include <optional>
#include <string>

#include "girth/error.h"
#include "girth/surface_mesh.h"

namespace girth {

/// VERTEX_OUT_OF_RANGE where the surface has no such vertex.
inline std::optional<Error> checkVertex(const SurfaceMesh& mesh, Vertex vertex) {
  if (vertex < mesh.vertexCount()) return std::nullopt;
  return makeError(ErrorCode::VertexOutOfRange, vertex,
                   "vertex " + std::to_string(vertex) + " of " +
                       std::to_string(mesh.vertexCount()) + " does not exist");
}

}  // namespace girth
