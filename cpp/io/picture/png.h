// Pictures as PNG, for reports that need no other file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "girth/export.h"

namespace girth::io {

/// Eight bits of grey, or of grey and opacity, for each pixel, row after row from the top.
/// `channels` is 1 or 2; `pixels` holds width · height · channels values. Compressed with the fixed
/// codes of RFC 1951, which is enough for small pictures. O(pixels).
GIRTH_EXPORT std::string greyPng(std::span<const std::uint8_t> pixels, std::uint32_t width,
                                 std::uint32_t height, unsigned channels);

}  // namespace girth::io
