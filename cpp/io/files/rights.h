// Rights to write a file, as the system has them: rights_posix.cpp and rights_windows.cpp.
#pragma once

#include <cstdio>
#include <filesystem>

namespace girth::io {

/// Whether a file that is there may be written; otherwise errno has the reason.
bool mayWriteFile(const std::filesystem::path& file);

/// Whether files may be made in a folder; otherwise errno has the reason.
bool mayWriteFolder(const std::filesystem::path& folder);

/// Gives a new file owner, group and mode of another one; whether it has them now. On Windows files
/// have the rights of their folder, and nothing is done.
bool copyRights(const std::filesystem::path& from, std::FILE* to);

}  // namespace girth::io
