// The older name of girth/subdivide_surface.h, until 2.0.
#pragma once

#include <utility>

#include "girth/subdivide_surface.h"
#include "girth/version.h"

namespace girth {

/// subdivideSurface.
GIRTH_DEPRECATED("use subdivideSurface")
inline Result<PreparedSurface> refineSurface(PreparedSurface surface, Index faces,
                                             const ExecutionContext& context = {}) {
  return subdivideSurface(std::move(surface), faces, context);
}

}  // namespace girth
