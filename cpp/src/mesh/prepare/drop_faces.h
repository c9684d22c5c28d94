// Faces that are none: without area, or there already.
#pragma once

#include <vector>

#include "mesh/prepare/working_faces.h"

namespace girth::prepare {

/// Drops faces that repeat a vertex. Where two vertices of a face without area lie next to nothing
/// apart (1e-12 of its longest side), they become one first: the smaller number in `first`, which
/// for each vertex names the one that stands for it.
void dropCollapsedFaces(WorkingFaces& faces, std::vector<Index>& first, PreparationReport& report);

/// Drops copies of faces; see PreparationReport::duplicateFaces for the rule.
void dropDuplicateFaces(WorkingFaces& faces, PreparationReport& report);

/// Drops faces without area, where need be after flipping their longest side: see
/// PreparationReport::flippedFaces. Returns whether there were
/// any: copies have to be looked at again then.
bool dropFlatFaces(WorkingFaces& faces, PreparationReport& report);

}  // namespace girth::prepare
