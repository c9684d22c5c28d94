// A surface written to a file, in one line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// Writes a surface to a file in the format of its name's ending (meshFormat), as meshFile makes
/// it. `unit`: as there. The file appears whole or not at all, as by saveField. Not in WebAssembly,
/// which has no files.
///
/// Returns the error, if there is one: USAGE for another ending; LIMIT_EXCEEDED; FILE_UNWRITABLE.
/// Each names the file (Error::file).
///
/// \code
/// if (const auto error = girth::io::saveMesh("copy.ply", mesh, "millimetre")) throw *error;
/// \endcode
[[nodiscard]] GIRTH_EXPORT std::optional<Error> saveMesh(const std::string& path,
                                                         const SurfaceMesh& mesh,
                                                         std::string_view unit = {});

}  // namespace girth::io
