// Parts of a shape, and the places that are too thin to print, as JSON.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/parts.h"
#include "girth/print_check.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `thresholds` (`girth`, `shapeDiameter`), `smoothing` and
/// `parts`: of each its `kind`, `area`, `medianGirth`, `medianShapeDiameter`, `equivalentRadius`
/// (tubes only), `thinnest` (as a point of `loopJson`, or null) and `vertices` (of the file).
/// Numbers that are not finite come out as null. `persistence`: that of the girth, behind `unit`,
/// where it is not 0.
GIRTH_EXPORT std::string partsJson(const LoadedMesh& loaded, const Parts& parts,
                                   const PartOptions& options, std::string_view file,
                                   double persistence = 0);

/// One JSON object: `file`, `unit`, `limits` (`tubeDiameter`, `wallThickness`, `gap`), `passes`,
/// `failingShare`, `passingScale` (null where no scale helps) and `places`: of each its `kind`
/// ("tube", "wall" or "gap"), `measure` ("diameter", "thickness" or "clearance"), `least`, `area`,
/// `thinnest`, `opposite` (walls and gaps: a position) and `vertices`; `creases`: of each its
/// `kind`
/// ("crease", "rounding" or "sliver"), `length` and the like. As in print_check.h.
/// `persistence`: as above.
GIRTH_EXPORT std::string printCheckJson(const LoadedMesh& loaded, const PrintCheck& check,
                                        const PrintLimits& limits, std::string_view file,
                                        double persistence = 0);

}  // namespace girth::io
