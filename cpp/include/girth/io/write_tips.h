// Tips and their contours as a file's content: JSON or OBJ.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/tips.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `crossedEdges`, `tips` and `arcs`. Each tip has `area`,
/// `boundaryLength`, `jump`, `apex` (as a point of `loopJson`), `apexDistance`, `vertices` (of the
/// file), and `contour`: lines with `closed` and `points` [x,y,z]. Each arc has `length`, `jump`
/// and `line`. `trials`, a JSON array (study::tipTrialsJson), becomes the member `trials`; empty:
/// there is none. `persistence`: that of the girth, behind `unit`, where it is not 0.
GIRTH_EXPORT std::string tipsJson(const LoadedMesh& loaded, const Tips& tips, std::string_view file,
                                  std::string_view trials = {}, double persistence = 0);

/// The contours as OBJ line elements: one object a tip (`o tip_0`, …) and one an arc (`o arc_0`,
/// …).
GIRTH_EXPORT std::string tipsObj(const LoadedMesh& loaded, const Tips& tips);

}  // namespace girth::io
