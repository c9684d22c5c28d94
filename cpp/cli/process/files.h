// The command's files, beside those that girth::io reads and writes (files/).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "girth/error.h"

namespace girth::cli {

/// The bytes of standard input, which later calls give again. Errors: FILE_UNREADABLE,
/// OUT_OF_MEMORY.
Result<std::vector<std::byte>> readStandardInput();

/// Makes the folder that a file is to be put into, and those above it. Error: FILE_UNWRITABLE.
std::optional<Error> makeFolderOf(const std::string& path);

/// Whether there is a file of this name, and no folder, pipe or device.
bool isFile(const std::string& path);

/// Whether there is a file of this name, or nothing.
bool isOrdinary(const std::string& path);

/// Removes a file, if it is there.
void removeFile(const std::string& path);

/// Gives a file another name beside it, which nothing has: "values.partial-2.csv" for
/// "values.partial.csv". The new name. Error: FILE_UNWRITABLE.
Result<std::string> keepAside(const std::string& path);

/// Whether two names mean one file that is there.
bool isSameFile(const std::string& one, const std::string& other);

}  // namespace girth::cli
