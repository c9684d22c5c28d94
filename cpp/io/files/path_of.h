// Names of files as the project has them, in UTF-8, and as paths of the system.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace girth::io {

/// The path that a name in UTF-8 means. `path(name)` would take it for the program's code page on
/// Windows; `path::string()` gives UTF-8 everywhere.
inline std::filesystem::path pathOf(std::string_view name) {
  return std::filesystem::path(std::u8string(name.begin(), name.end()));
}

}  // namespace girth::io
