// A model from a file, in one line: its surface, or its triangles as they are.
#pragma once

#include <string>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/prepare_surface.h"

namespace girth::io {

/// The model in a file, prepared: `readMesh` of its bytes, with the files that a glTF refers to.
/// They are looked for beside it and below, and nowhere else: neither a name nor a symbolic link
/// leads out of its folder. The format (GLB, glTF, OBJ, PLY, STL or OFF) is recognised by content;
/// the name's ending only breaks ties. Not in WebAssembly, which has no files.
///
/// Errors: FILE_NOT_FOUND, FILE_UNREADABLE, and those of readMesh; each names the file
/// (Error::file).
///
/// \code
/// const auto loaded = girth::io::loadMesh("model.obj");
/// if (!loaded) throw loaded.error();
/// std::cout << loaded.value().mesh.faceCount() << ' ' << loaded.value().unit << '\n';
/// \endcode
GIRTH_EXPORT Result<LoadedMesh> loadMesh(const std::string& path,
                                         const PrepareOptions& options = {},
                                         const ExecutionContext& context = {});

/// The model in a file as it is there, nothing repaired: `readModel` of its bytes, with the same
/// files beside it. Errors: FILE_NOT_FOUND, FILE_UNREADABLE, and those of readModel; each names the
/// file (Error::file).
GIRTH_EXPORT Result<ReadModel> loadModel(const std::string& path);

}  // namespace girth::io
