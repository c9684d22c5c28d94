// Bodies that a file lists one after the other.
#pragma once

#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// Separates bodies that lie on one another in a file of facets, each with vertices of its own. A
/// body ends where, in the order of the file, the faces so far that edges connect are closed: they
/// run along every edge equally often in both directions. `place` names for each vertex the first
/// one at its position, kNoIndex for one that no face uses. Returns for each vertex the first one
/// of its body at its place. Empty: no body ends before the last face that is connected to it. O(n
/// log n).
std::vector<Index> firstInBody(std::span<const Index> triangles, const std::vector<Index>& place);

}  // namespace girth::prepare
