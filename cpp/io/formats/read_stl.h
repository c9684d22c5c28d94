// STL (stereolithography) to triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Whether the size is that of binary STL: 84 bytes and 50 for each triangle that it counts, at
/// least one. No text can look like that: its letters would count hundreds of millions.
bool hasBinaryStlSize(std::span<const std::byte> bytes);

/// Whether a text begins with "solid", in any case.
bool hasStlMark(std::string_view text);

/// Reads ASCII (several solids, keywords in any case, any white space, polygons cut into triangles)
/// and binary, distinguished by size and content: binary files may begin with "solid", too. Every
/// corner of a triangle is a vertex of its own, in the file's order: 3 f + k is corner k of
/// triangle f. Normals, colours and names are passed over; the sides are what the corners' order
/// says.
///
/// Where the size of a binary file is that of whole triangles, it decides on their number, with a
/// note if the header counts others. A file of another size that counts more triangles than it
/// holds is refused; what follows those that it counts is passed over, with a note. ASCII ends
/// loops, facets and solids in one word or two; control characters in names are padding. Errors
/// name the line or, in binary files, the byte. See readModel.
Result<ReadModel> readStl(std::span<const std::byte> bytes);

}  // namespace girth::io
