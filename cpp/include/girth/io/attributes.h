// Attributes of vertices in files, besides positions: colours, texture coordinates, fields.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <string>
#include <vector>

#include "girth/export.h"
#include "girth/prepare_surface.h"
#include "girth/triangle_soup.h"

namespace girth::io {

/// An attribute of vertices, or of the corners of faces.
struct Attribute {
  /// As glTF names it: `COLOR_0`, `TEXCOORD_0`, ..., or `_` and a name of one's own.
  std::string name;
  /// Numbers of each: 3 or 4 of a colour, 2 of a texture coordinate, 1 of a field.
  Index width{1};
  /// Colours, which lie in [0, 1], are in proportion to light, as in glTF; otherwise as on a screen
  /// (sRGB), as in PLY and OBJ.
  bool isLinear{false};
  /// Width numbers for each; NaN where there is none.
  std::vector<double> values;
  /// The corners of triangles, where they differ at a vertex as along the seam of a texture:
  /// whose values of all a corner has, kNoIndex where it has none. Empty: `values` are those of the
  /// vertices, or of the corners, in order.
  std::vector<Index> corners{};
};

/// Attributes of the corners of a surface's faces, halfedge by halfedge: those of the corner of the
/// input's triangle at the same position, and elsewhere in it, as on surfaces that were refined,
/// linear between its corners. NaN in faces that were made. `attributes`: of the vertices, or the
/// corners, of `soup`, which `surface` was prepared from, with its positions times `scale`.
GIRTH_EXPORT std::vector<Attribute> cornerAttributes(const std::vector<Attribute>& attributes,
                                                     const TriangleSoup& soup, double scale,
                                                     const PreparedSurface& surface);

}  // namespace girth::io
