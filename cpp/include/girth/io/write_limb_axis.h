// The axis of a limb and the loops along it as a file's content: CSV, JSON, OBJ or GLB.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/limb_axis.h"

namespace girth::io {

/// `distance,along,girth,area,x,y,z,unit` and a row for each loop: x, y and z are the axis.
GIRTH_EXPORT std::string limbAxisCsv(const LoadedMesh& loaded, std::span<const AxisStation> axis);

/// One JSON object: `file`, `unit`, `length` of the axis, and `loops`. Each has `distance`,
/// `along`, `girth`, `area`, `centre` and `points` (as those of `loopJson`).
GIRTH_EXPORT std::string limbAxisJson(const LoadedMesh& loaded, std::span<const AxisStation> axis,
                                      std::string_view file);

/// The loops as closed lines, objects `loop_0`, ..., and the axis as an open one, `axis`.
GIRTH_EXPORT std::string limbAxisObj(const LoadedMesh& loaded, std::span<const AxisStation> axis);

/// The loops as line strips, nodes `loop_0`, ... Error: LIMIT_EXCEEDED where the file would pass
/// 4 GB.
GIRTH_EXPORT Result<std::string> limbAxisGlb(const LoadedMesh& loaded,
                                             std::span<const AxisStation> axis);

}  // namespace girth::io
