// A look at JSON before a recursive parser sees it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace girth::io {

/// The byte at which arrays and objects are nested more than `limit` deep; nothing if they never
/// are. Brackets inside strings do not count.
std::optional<std::size_t> nestingBeyond(std::string_view json, std::size_t limit);

}  // namespace girth::io
