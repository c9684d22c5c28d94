// Handles and tunnels as a file's content: JSON, CSV, OBJ or GLB.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/handles.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `unresolved` and `handles`. Each handle has `length`, `kind`
/// ("handle", "tunnel" or "unknown"), `component`, `area`, `centre` and `points` (as those of
/// `loopJson`).
GIRTH_EXPORT std::string handlesJson(const LoadedMesh& loaded, const Handles& handles,
                                     std::string_view file);

/// `handle,length,kind,component,area,x,y,z,unit` and a row for each; x, y, z is the centre.
GIRTH_EXPORT std::string handlesCsv(const LoadedMesh& loaded, const Handles& handles);

/// Each as an object `handle_0`, `tunnel_1`, ... with a closed line element.
GIRTH_EXPORT std::string handlesObj(const LoadedMesh& loaded, const Handles& handles);

/// Each as a node `handle_0`, `tunnel_1`, ... with a line strip (mode 3), positions rounded to
/// floats; in the mesh's `extras` its `length`, `kind` and `unit`. glTF is in metres, as in
/// fieldGlb. An empty scene where there is none. Error: LIMIT_EXCEEDED where the file would pass
/// 4 GB.
GIRTH_EXPORT Result<std::string> handlesGlb(const LoadedMesh& loaded, const Handles& handles);

}  // namespace girth::io
