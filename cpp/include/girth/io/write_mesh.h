// A surface as a file's content: OBJ, PLY, STL, OFF or GLB.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// The surface in a format. OBJ and OFF are text whose numbers read back as the same doubles; PLY
/// is binary little-endian with doubles; STL is binary and GLB is, both with positions rounded to
/// floats, which may put vertices that lie very close onto one point. `unit` as in ReadModel, and
/// readModel reads it again: GLB is in metres, so that a model in another length that is known
/// ("millimetre", ...) is scaled by its node; where it is not known, other programs take the
/// numbers for metres. Other formats have the unit in a comment or in their header.
///
/// Errors: USAGE for Format::Gltf (write GLB), LIMIT_EXCEEDED where GLB would pass 4 GB.
GIRTH_EXPORT Result<std::string> meshFile(const SurfaceMesh& mesh, Format format,
                                          std::string_view unit = {});

/// The format that a file's name asks for by its ending, in small letters: ".obj", ".ply", ".stl",
/// ".off" or ".glb". Nothing for another one.
GIRTH_EXPORT std::optional<Format> meshFormat(std::string_view ending);

}  // namespace girth::io
