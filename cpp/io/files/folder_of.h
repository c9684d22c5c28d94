// The folder that a file is in.
#pragma once

#include <filesystem>

namespace girth::io {

/// The folder that a file is in, or is to be put into.
inline std::filesystem::path folderOf(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace girth::io
