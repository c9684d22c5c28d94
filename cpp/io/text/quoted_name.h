// Bits of text for messages about untrusted files.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// A name out of a file, quoted for a one-line message: control characters replaced, cut when long.
GIRTH_EXPORT std::string inQuotes(std::string_view name);

/// ` "name"`, or nothing where there is no name.
std::string spacedName(std::string_view name);

}  // namespace girth::io
