// The report on preparing a surface, as JSON.
#pragma once

#include <string>

#include "girth/export.h"
#include "girth/prepare_surface.h"

namespace girth::io {

/// One object with the members of PreparationReport under their names.
GIRTH_EXPORT std::string reportJson(const PreparationReport& report);

}  // namespace girth::io
