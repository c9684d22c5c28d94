// PLY (the Stanford polygon format) to triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Whether a file begins as PLY does.
bool hasPlyMark(std::string_view text);

/// Reads ASCII and binary of both byte orders: x, y, z of the element `vertex`; the polygons
/// `vertex_indices` (or `vertex_index`) of `face`; the strips of `tristrips`, where -1 starts a new
/// one. Other elements and properties, also lists, may stand anywhere and are passed over; in text
/// also those of unknown types, in binary files where their size is known, or nothing that is read
/// follows. In ASCII every element begins on a line of its own and its values are rounded correctly
/// to doubles, whatever type the header gives them.
///
/// Errors name the line of the header and of ASCII, the byte of binary files. A point cloud is
/// EMPTY_MESH with a message that says so. See readModel.
Result<ReadModel> readPly(std::span<const std::byte> bytes, const ReadOptions& options = {});

}  // namespace girth::io
