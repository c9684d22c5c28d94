// Vertices at the same place become one.
#pragma once

#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// For each vertex the first used one at exactly its position (0 and −0 are equal), kNoIndex for
/// those that no triangle uses. Sorts within buckets of a hash: no input can make it slower than
/// O(n log n).
std::vector<Index> firstAtSamePlace(std::span<const double> positions,
                                    std::span<const Index> triangles);

/// Goes on from there: in the order of the vertices, each that stands for itself is joined to the
/// nearest earlier one within `distance` that still stands for itself (of equals the first), if
/// there is one. Clusters so reach no farther than `distance`, and those that remain are farther
/// apart than that.
void joinWithin(double distance, std::span<const double> positions, std::vector<Index>& first);

}  // namespace girth::prepare
