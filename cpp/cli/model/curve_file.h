// Curves on a model out of files.
#pragma once

#include <string>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {

/// The curves of a file: an OBJ file's lines where its name ends in .obj, otherwise those of JSON
/// (io/read_curves.h). Errors have its name.
Result<std::vector<SurfaceCurve>> readCurveFile(const std::string& path,
                                                const io::LoadedMesh& loaded);

}  // namespace girth::cli
