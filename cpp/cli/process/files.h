// The command's files: the only place of the project that touches the file system.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {

/// A file's bytes. Errors: FILE_NOT_FOUND, FILE_UNREADABLE, OUT_OF_MEMORY.
Result<std::vector<std::byte>> readFile(const std::string& path);

/// The bytes of standard input, which later calls give again. Errors: FILE_UNREADABLE,
/// OUT_OF_MEMORY.
Result<std::vector<std::byte>> readStandardInput();

/// Reads the files beside a model; never outside its folder, even by way of a symbolic link.
io::ResourceReader resourcesBeside(const std::string& modelPath);

/// Writes `content` to `path` as a whole or not at all: a file that is there is replaced only by
/// the finished one, which is written beside it and gets its owner and mode. A symbolic link is
/// followed. Where the owner is another one who cannot be kept, the file is overwritten. Error:
/// FILE_UNWRITABLE.
std::optional<Error> writeFile(const std::string& path, std::string_view content);

/// Checks before long work that `writeFile` can succeed. Error: FILE_UNWRITABLE.
std::optional<Error> checkWritable(const std::string& path);

/// Makes the folder that a file is to be put into, and those above it. Error: FILE_UNWRITABLE.
std::optional<Error> makeFolderOf(const std::string& path);

/// Whether there is a file of this name, and no folder, pipe or device.
bool isFile(const std::string& path);

/// Whether there is a file of this name, or nothing.
bool isOrdinary(const std::string& path);

/// Removes a file, if it is there.
void removeFile(const std::string& path);

/// Whether two names mean one file that is there.
bool isSameFile(const std::string& one, const std::string& other);

/// The name's ending in lower case with its dot: ".csv".
std::string extensionOf(const std::string& path);

}  // namespace girth::cli
