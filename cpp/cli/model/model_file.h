// A model's bytes, wherever they are: in a file, on standard input, packed by gzip, or in a zip.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {

struct ModelFile {
  std::vector<std::byte> bytes;
  /// The name by which the format may be guessed, and which messages have.
  std::string name;
  /// The files that the model refers to: beside it, or in the same zip.
  io::ResourceReader resources;
};

/// Opens the model. `path`: "-" is standard input, which is kept for a second call. `entry`: which
/// file of a zip; empty: the first model in it, by the number of folders, then by name. A note on
/// standard error names it where there are several. Errors: those of readFile, gunzip and unzipped;
/// FILE_NOT_FOUND for an entry that there is not, UNKNOWN_FORMAT for a zip without models, USAGE
/// for an entry of what is no zip.
Result<ModelFile> openModel(const std::string& path, const std::string& entry = "");

}  // namespace girth::cli
