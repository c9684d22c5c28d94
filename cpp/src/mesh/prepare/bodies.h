// Bodies that a file lists one after the other.
#pragma once

#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// Bodies with vertices of their own.
struct Bodies {
  /// For each vertex the first one of its body at its place. Empty: no body ends before the last
  /// face that is connected to it.
  std::vector<Index> first;
  /// For each vertex that was added, since faces of several bodies have one, that one. They come
  /// after all others.
  std::vector<Index> copied;
};

/// Separates bodies that lie on one another in a file. A body ends where, in the order of the file,
/// the faces so far that edges connect are closed: they run along every edge equally often in both
/// directions. Where faces share vertices, bodies connected by edges are told apart only if each
/// edge of each has two faces: then their own numbers close them for whoever reads them next.
/// `place` names for each vertex the first one at its position, kNoIndex for one that no face uses;
/// vertices that are added are appended, and `triangles` names them. O(n log n).
Bodies separateBodies(std::vector<Index>& triangles, std::vector<Index>& place);

}  // namespace girth::prepare
