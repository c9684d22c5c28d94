// A model in fewer triangles, for measuring: `--faces`.
#pragma once

#include <cstdint>
#include <string>

#include "girth/error.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {

/// The model's surface remeshed to at most so many triangles; as it is where it has no more. A
/// vertex of the file then stands for the nearest one of the surface, and one of the surface has
/// the number of the nearest in the file; faces come from none of the file. A note says that it was
/// done. `model`: for messages. Errors: those of remesh, CANCELLED.
Result<io::LoadedMesh> inFewerTriangles(const std::string& model, io::LoadedMesh loaded,
                                        std::uint32_t faces);

/// USAGE: what names faces of the file does not go with `--faces`. `hint`: what does.
Error otherFaces(const std::string& hint);

}  // namespace girth::cli
