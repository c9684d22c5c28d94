// A part of a surface that was cut, with what the model's file says of its vertices.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/write_cut.h"

namespace girth::io {

/// Triangles whose vertices have one value of each attribute: where the corners at a vertex differ,
/// as along the seam of a texture, it stands several times.
struct AttributedPart {
  std::vector<Vec3> places;
  std::vector<Index> triangles;
  /// Attributes of the vertices: as they are at vertices of the model, linear in between; NaN where
  /// there is none. Caps have the values of their rims.
  std::vector<Attribute> attributes;
};

/// Without attributes the vertices and triangles are those of the part.
AttributedPart attributedPart(const LoadedMesh& loaded, const CutModel& model, std::size_t part);

/// Appends a part's vertices and faces, and the colours and texture coordinates. `before`: vertices
/// that stand before it.
void appendObj(const AttributedPart& part, std::size_t before, std::string& text);

/// The part as binary PLY: colours as bytes, all other numbers as doubles.
std::string plyFile(const AttributedPart& part, std::string_view unit);

}  // namespace girth::io
