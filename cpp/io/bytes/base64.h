// Bytes as base64 text (RFC 4648), for data: URIs.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"

namespace girth::io {

/// The bytes as base64 with padding, without line breaks.
GIRTH_EXPORT std::string base64(std::string_view bytes);

}  // namespace girth::io
