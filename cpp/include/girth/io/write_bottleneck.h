// The bottleneck between two points as a file's content: JSON, OBJ or GLB.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <string>
#include <string_view>

#include "girth/bottleneck.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `kind`, `girth`, `place` (as the points of `loopJson`),
/// `centre`, `area`, `sides` (of each `area` and `volume`; none unless it is a neck), `points` and
/// `way`.
GIRTH_EXPORT std::string bottleneckJson(const LoadedMesh& loaded, const Bottleneck& bottleneck,
                                        std::string_view file);

/// The loop as an object `bottleneck` with a closed line element, and the way as an object `way`
/// with an open one.
GIRTH_EXPORT std::string bottleneckObj(const LoadedMesh& loaded, const Bottleneck& bottleneck);

/// The bottleneck as nodes with line strips (mode 3), positions rounded to floats; in the mesh's
/// `extras` of the loop its `girth`, `kind` and `unit`. glTF is in metres, as in fieldGlb. Error:
/// LIMIT_EXCEEDED where the file would pass 4 GB.
GIRTH_EXPORT Result<std::string> bottleneckGlb(const LoadedMesh& loaded,
                                               const Bottleneck& bottleneck);

}  // namespace girth::io
