// Curves on a model out of files that Girth has written.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <string_view>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// All `points` of a JSON document as loopJson, necksJson, handlesJson, bottleneckJson,
/// limbAxisJson and `resultJson` of distances and tight curves write it: those of the document
/// itself, or of each of its `necks`, `handles`, `loops` or `distances`. Vertices are those of the
/// file that the model was read from. Errors: MALFORMED_FILE (no JSON, no points, or points without
/// `vertices` and `weights`), INVALID_POINT (element: the point's place in its curve) where the
/// model has no such vertex, edge or face.
GIRTH_EXPORT Result<std::vector<SurfaceCurve>> readCurves(std::string_view json,
                                                          const LoadedMesh& loaded);

/// The lines of an OBJ file: those of its elements `l`, of which one that begins where the one
/// before ends goes on; without any, all its vertices in order. Each vertex is taken to the nearest
/// point of the surface. Errors: MALFORMED_FILE (line), INVALID_POINT (the point's place in its
/// curve) where one lies farther beside the surface than 0.001 of the model's diagonal.
GIRTH_EXPORT Result<std::vector<SurfaceCurve>> readCurvesObj(std::string_view obj,
                                                             const LoadedMesh& loaded);

}  // namespace girth::io
