// Bytes as base64 text (RFC 4648), for data: URIs.
#pragma once

#include <string>
#include <string_view>

namespace girth::io {

/// The bytes as base64 with padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace girth::io
