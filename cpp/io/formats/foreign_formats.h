// Files that are no models of ours, but that people have: what they are, and what to do with them.
#pragma once

#include <optional>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"

namespace girth::io {

/// The error that names the format of a file by its first bytes, with the way out; nothing where it
/// is none of those known here.
std::optional<Error> foreignFormat(std::string_view bytes);

/// The error of `foreignFormat` for a file that may be a model: nothing for files beside models,
/// such as pictures.
GIRTH_EXPORT std::optional<Error> foreignModel(std::string_view bytes);

}  // namespace girth::io
