// Handles and tunnels, as long as their loops are shorter than a length.
#pragma once

#include <optional>

#include "girth/handles.h"
#include "infinity.h"

namespace girth::loops {

/// The handles of a surface, and what was proven of them.
struct HandlesUpTo {
  Handles handles;
  /// All loops that are shorter, and of handle or tunnel kind, are sums of those found; where a
  /// length was asked for.
  double proven{kInfinity};
};

/// findHandles. With a length, loops that are shorter are proven to be the shortest, and it is
/// proven that no other one is shorter than this, as far as the budget goes; with 0, nothing is
/// proven.
Result<HandlesUpTo> findHandlesUpTo(const SurfaceMesh& mesh, std::optional<double> length,
                                    const HandleOptions& options, const ExecutionContext& context);

}  // namespace girth::loops
