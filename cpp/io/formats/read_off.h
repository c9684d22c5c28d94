// OFF (Geomview's object file format) to triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Whether a text begins with a keyword of OFF: OFF itself, with any of ST, C, N, 4 and n before
/// it.
bool hasOffMark(std::string_view text);

/// Whether a text without the keyword can still be OFF: it begins with two or three whole numbers
/// on a line of their own.
bool canBeOffWithoutMark(std::string_view text);

/// Reads ASCII and binary ("OFF BINARY": big-endian integers and floats of 32 bits, each face with
/// the number of its colour's components and those, as Geomview writes it). The prefixes ST, C and
/// N (texture coordinates, colours, normals) are understood and what they announce is passed over;
/// with 4, positions are divided by their fourth component; with n it is refused. In ASCII there
/// may be comments (#), the counts may stand beside the keyword, the keyword may be missing. Where
/// every vertex and every face stands on a line of its own, what follows its numbers there
/// (colours) is passed over, announced or not. Otherwise lines may be broken anywhere, where the
/// numbers are exactly those that are counted and announced; then only a face's colour ends with
/// its line. Faces of fewer than three corners are left out, with a note.
///
/// Errors name the line or, in binary files, the byte. See readModel.
Result<ReadModel> readOff(std::span<const std::byte> bytes);

}  // namespace girth::io
