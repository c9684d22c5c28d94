// Fields written to a file, in one line.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/girth_field.h"
#include "girth/io/read_mesh.h"
#include "girth/io/vertex_field.h"
#include "girth/io/write_field.h"

namespace girth::io {

/// Writes fields to a file in the format of its name's ending: .csv, .json, .npy, .ply or .glb
/// (fieldFile). The file appears whole or not at all: one that is there is replaced by the finished
/// one, which keeps its mode and owner, and a symbolic link is followed. Not in WebAssembly, which
/// has no files.
///
/// Returns the error, if there is one: USAGE for another ending, and as of checkFields and
/// fieldFile; LIMIT_EXCEEDED; FILE_UNWRITABLE. Each names the file (Error::file).
[[nodiscard]] GIRTH_EXPORT std::optional<Error> saveField(const std::string& path,
                                                          const LoadedMesh& loaded,
                                                          std::span<const VertexField> fields,
                                                          Columns columns = Columns::Fields);

/// Saves one field.
[[nodiscard]] GIRTH_EXPORT std::optional<Error> saveField(const std::string& path,
                                                          const LoadedMesh& loaded,
                                                          const VertexField& field,
                                                          Columns columns = Columns::Fields);

/// Saves the girth, as the field "igf". `method`: the one that it was computed by.
///
/// \code
/// const auto loaded = girth::io::loadMesh("model.obj").value();
/// const girth::GirthField field = girth::girthField(loaded.mesh);
/// if (const auto error = girth::io::saveField("girth.csv", loaded, field)) throw *error;
/// \endcode
[[nodiscard]] GIRTH_EXPORT std::optional<Error> saveField(const std::string& path,
                                                          const LoadedMesh& loaded,
                                                          const GirthField& field,
                                                          GirthMethod method = GirthMethod::Exact);

}  // namespace girth::io
