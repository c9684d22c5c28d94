// Parts of a shape, and the places that are too thin to print, as JSON.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/parts.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `thresholds` (`girth`, `thickness`), `smoothing` and `parts`:
/// of each its `kind`, `area`, `medianGirth`, `medianThickness`, `equivalentRadius` (tubes only),
/// `thinnest` (as a point of `loopJson`, or null) and `vertices` (of the file). Numbers that are
/// not finite come out as null.
GIRTH_EXPORT std::string partsJson(const LoadedMesh& loaded, const Parts& parts,
                                   const PartOptions& options, std::string_view file);

/// One JSON object: `file`, `unit`, `limits` (`tubeDiameter`, `wallThickness`), `passes`,
/// `failingShare`, `passingScale` (null where no scale helps) and `places`: of each its `kind`
/// ("tube" or "wall"), `measure` ("diameter" or "thickness"), `least`, `area`, `thinnest` and
/// `vertices`. `passingScale`: see parts.h.
GIRTH_EXPORT std::string weakPlacesJson(const LoadedMesh& loaded, std::span<const WeakPlace> places,
                                        const PrintLimits& limits, double passingScale,
                                        std::string_view file);

}  // namespace girth::io
