// Wavefront OBJ to triangles.
#pragma once

#include <cstddef>
#include <span>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Reads positions and faces; everything else in the file is passed over. Coordinates are rounded
/// correctly, errors name the line (also as their element). See readSoup.
Result<TriangleSoup> readObj(std::span<const std::byte> bytes);

/// Whether a line could be one of an OBJ file, by its first word.
bool isObjLine(std::string_view line);

}  // namespace girth::io
