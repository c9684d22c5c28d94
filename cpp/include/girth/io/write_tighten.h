// A curve drawn tight as a file's content: OBJ or GLB.
#pragma once

#include <string>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/tighten.h"

namespace girth::io {

// JSON is `resultJson`, and CSV with a row for each piece `resultCsv`, by
// girth/describe/tighten.h.

/// The curve as a line element; a comment alone where it is a point.
GIRTH_EXPORT std::string tightObj(const LoadedMesh& loaded, const TightCurve& curve);

/// The curve as a line strip (mode 3), positions rounded to floats; in the mesh's `extras` its
/// `kind`, `promise`, `lengthBefore`, `length` and `unit`. glTF is in metres, as in fieldGlb. An
/// empty scene where it is a point. Error: LIMIT_EXCEEDED where the file would pass 4 GB.
GIRTH_EXPORT Result<std::string> tightGlb(const LoadedMesh& loaded, const TightCurve& curve);

}  // namespace girth::io
