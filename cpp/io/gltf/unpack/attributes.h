// Attributes that a glTF scene gives its points besides their places: colours, texture coordinates,
// and the scalars of an application.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/attributes.h"
#include "gltf/document/document.h"
#include "gltf/unpack/point_numbers.h"

namespace girth::io {

/// The triangles that a primitive has become, each time that it was placed.
struct PlacedPrimitive {
  std::uint32_t mesh{0};
  std::uint32_t primitive{0};
  /// None where the primitive is not packed.
  const DracoMesh* packed{nullptr};
  Index firstPoint{0};
  Index pointCount{0};
  /// In the corners of all triangles.
  std::size_t firstCorner{0};
  std::size_t endCorner{0};
};

/// Attributes of the corners of triangles, and what is left out or missing, one sentence each.
struct GltfAttributes {
  std::vector<Attribute> attributes;
  std::vector<std::string> notes;
};

/// Whether the attribute of that name is read: COLOR_0, TEXCOORD_0, and `_NAME` of at most 64
/// printing characters of ASCII.
bool isKeptAttribute(std::string_view name);

/// Reads the attributes of a scene. COLOR_0 is multiplied by the base colour of the material, and
/// white where there is neither; the others have no value where a primitive does not have them. The
/// first 16 `_NAME`s in their alphabet are read. Values are read once, however often a mesh is
/// placed, and taken from the budget; the corners' numbers stay in proportion to the bytes that it
/// was made for. An attribute that does not fit or cannot be read is left out, with a note.
GltfAttributes attributesOf(const GltfDocument& document, PointNumbers& points,
                            const SoupBudget& budget, const std::vector<PlacedPrimitive>& placed,
                            const std::vector<Index>& triangles);

}  // namespace girth::io
