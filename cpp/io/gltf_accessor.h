// Reading the numbers behind glTF accessors, with every count, stride and offset checked.
#pragma once

#include <vector>

#include "girth/surface_mesh.h"
#include "gltf_buffers.h"
#include "soup_budget.h"

namespace girth::io {

/// The points of a POSITION accessor, x, y, z each: any component type, normalised or not, sparse
/// or not. Takes its count from the budget. Errors: MALFORMED_FILE, UNSUPPORTED_FEATURE,
/// LIMIT_EXCEEDED and those of GltfBuffers.
Result<std::vector<double>> readPoints(const GltfDocument& document, GltfBuffers& buffers,
                                       int accessor, SoupBudget& budget);

/// The vertex numbers of an index accessor, unchecked against the number of vertices. Budget and
/// errors as above.
Result<std::vector<Index>> readIndices(const GltfDocument& document, GltfBuffers& buffers,
                                       int accessor, SoupBudget& budget);

}  // namespace girth::io
