// Files read as bytes, and the files beside a model.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// A file's bytes. Errors: FILE_NOT_FOUND, FILE_UNREADABLE, OUT_OF_MEMORY.
GIRTH_EXPORT Result<std::vector<std::byte>> readFile(const std::string& path);

/// All bytes of an open file, from where it is. Errors: FILE_UNREADABLE, OUT_OF_MEMORY.
GIRTH_EXPORT Result<std::vector<std::byte>> readToEnd(std::FILE* file);

/// Reads the files beside a model; never outside its folder, even by way of a symbolic link.
GIRTH_EXPORT ResourceReader resourcesBeside(const std::string& modelPath);

}  // namespace girth::io
