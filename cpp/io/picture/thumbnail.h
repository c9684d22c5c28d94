// A small picture of a surface.
#pragma once

#include <cstdint>
#include <string>

#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// The surface as a square PNG of grey and opacity, `size` pixels a side (at most 4096): seen along
/// its thinnest direction, its longest lying across, lit from where one looks. O(faces + size²).
GIRTH_EXPORT std::string thumbnailPng(const SurfaceMesh& mesh, std::uint32_t size);

}  // namespace girth::io
