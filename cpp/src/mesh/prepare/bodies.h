// Bodies that a file lists one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// How the vertices of a file are shared.
enum class CornerSharing : std::uint8_t {
  None,  ///< every corner is a vertex of its own
  Some   ///< faces share vertices, for example those of one flat side
};

/// Separates bodies that lie on one another in a file. A body ends where, in the order of the file,
/// the faces so far that edges connect are closed: they run along every edge equally often in both
/// directions. Where faces share vertices, a body is one only if each of its edges has two faces
/// and no other face has its vertices: then its own numbers close it for whoever reads it next.
/// `place` names for each vertex the first one at its position, kNoIndex for one that no face uses.
/// Returns for each vertex the first one of its body at its place. Empty: no body ends before the
/// last face that is connected to it. O(n log n).
std::vector<Index> firstInBody(std::span<const Index> triangles, const std::vector<Index>& place,
                               CornerSharing sharing);

}  // namespace girth::prepare
