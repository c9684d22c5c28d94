// Wavefront OBJ to triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Reads positions (`v`) and faces (`f`, `fo`); everything else in the file is passed over. Faces
/// may name vertices from 1, from the end (negative), and before they come; a backslash at the end
/// of such a line joins the next one on. The first three numbers of a vertex are its position:
/// colours behind them mean nothing here, nor does a fourth number, w: it is the weight of a
/// control point of a rational curve or surface and never divides the position of a polygon's
/// corner. Where some w is not 1, and it is not a colour, a note reports that it was ignored.
///
/// Coordinates are rounded correctly, errors name the line (also as their element). See readModel.
Result<ReadModel> readObj(std::span<const std::byte> bytes, const ReadOptions& options = {});

/// Whether a line could be one of an OBJ file, by its first word.
bool isObjLine(std::string_view line);

}  // namespace girth::io
