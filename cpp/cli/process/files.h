// The command's files: the only place of the project that touches the file system.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {

/// A file's bytes. Errors: FILE_NOT_FOUND, FILE_UNREADABLE, OUT_OF_MEMORY.
Result<std::vector<std::byte>> readFile(const std::string& path);

/// Reads the files beside a model; never outside its folder, even by way of a symbolic link.
io::ResourceReader resourcesBeside(const std::string& modelPath);

/// Writes `content` to `path` as a whole or not at all: a file that is there is replaced only by
/// the finished one. Error: FILE_UNWRITABLE.
std::optional<Error> writeFile(const std::string& path, std::string_view content);

/// Checks before long work that `writeFile` can succeed. Error: FILE_UNWRITABLE.
std::optional<Error> checkWritable(const std::string& path);

/// Checks before long work that a command can write its result there: the name has one of the
/// endings (".csv"), and `checkWritable` finds no error. Errors: USAGE, FILE_UNWRITABLE.
std::optional<Error> checkOutput(const std::string& path,
                                 std::initializer_list<std::string_view> endings);

/// The name's ending in lower case with its dot: ".csv".
std::string extensionOf(const std::string& path);

}  // namespace girth::cli
