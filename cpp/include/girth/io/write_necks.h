// Necks as a file's content: JSON, CSV, OBJ or GLB.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/necks.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `unresolved` and `necks`. Each neck has `length`, `prominence`
/// (null where no narrower neck can be reached), `width`, `area`, `radius`, `centre`, `normal`,
/// `sides` (of each `area` and `volume`), `measuresGirth`, `touchesBoundary`, `vertices` (of the
/// file) and `points` (as those of `loopJson`).
GIRTH_EXPORT std::string necksJson(const LoadedMesh& loaded, const Necks& necks,
                                   std::string_view file);

/// `neck,length,prominence,width,area,radius,x,y,z,normalX,normalY,normalZ,measuresGirth,unit` and
/// a row for each neck; x, y, z is the centre. The prominence is empty where it is infinite.
GIRTH_EXPORT std::string necksCsv(const LoadedMesh& loaded, const Necks& necks);

/// Each neck as an object `neck_0`, ... with a closed line element.
GIRTH_EXPORT std::string necksObj(const LoadedMesh& loaded, const Necks& necks);

/// Each neck as a node `neck_0`, ... with a line strip (mode 3), positions rounded to floats; in
/// the mesh's `extras` its `length`, `prominence`, `area` and `unit`. glTF is in metres, as in
/// fieldGlb. An empty scene where there is no neck. Error: LIMIT_EXCEEDED where the file would pass
/// 4 GB.
GIRTH_EXPORT Result<std::string> necksGlb(const LoadedMesh& loaded, const Necks& necks);

}  // namespace girth::io
