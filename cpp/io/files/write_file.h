// Files written as a whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"

namespace girth::io {

/// Writes `content` to `path` as a whole or not at all: a file that is there is replaced only by
/// the finished one, which is written beside it and gets its owner and mode. A symbolic link is
/// followed. Where the owner is another one who cannot be kept, the file is overwritten. Error:
/// FILE_UNWRITABLE.
GIRTH_EXPORT std::optional<Error> writeFile(const std::string& path, std::string_view content);

/// Checks before long work that `writeFile` can succeed. Error: FILE_UNWRITABLE.
GIRTH_EXPORT std::optional<Error> checkWritable(const std::string& path);

}  // namespace girth::io
