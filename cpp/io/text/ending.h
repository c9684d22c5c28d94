// The ending of a file's name.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// The name's ending in lower case with its dot, ".csv"; empty where it has none.
GIRTH_EXPORT std::string endingOf(std::string_view name);

}  // namespace girth::io
