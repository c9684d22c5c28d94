// Tubes as a file's content: CSV, OBJ, GLB, or a report in HTML.
#pragma once

#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/tubes.h"

namespace girth::io {

// JSON is `resultJson`, and CSV with a row for each station `resultCsv`, by girth/describe/tubes.h.

/// A row for each narrowing and widening: its `number` from 0, and a column for each number and
/// place.
GIRTH_EXPORT std::string tubePlacesCsv(const LoadedMesh& loaded, const Tubes& tubes);

/// The centreline of each branch as an object `branch_0`, ... and the outlines of narrowings and
/// widenings as `place_0`, ..., with line elements.
GIRTH_EXPORT std::string tubesObj(const LoadedMesh& loaded, const Tubes& tubes);

/// The outlines of all stations as nodes `station_0`, ... and those of narrowings and widenings as
/// `place_0`, ..., with line strips (mode 3), positions rounded to floats; in the mesh's `extras`
/// the `distance`, `equivalentDiameter`, `girth` and `unit`. glTF is in metres, as in fieldGlb. An
/// empty scene where there is no tube. Error: LIMIT_EXCEEDED where the file would pass 4 GB.
GIRTH_EXPORT Result<std::string> tubesGlb(const LoadedMesh& loaded, const Tubes& tubes);

/// The reason in words, behind the name of the component: "is less than 2.5 times as long as wide".
GIRTH_EXPORT std::string_view noTubeWords(NoTube reason);

/// The place that a branch leads to: "open end", "closed end" or "branching".
GIRTH_EXPORT std::string_view branchEndWords(const TubeBranch& branch);

/// A page of its own: the outlines seen from two sides, diameters and girth along each branch as
/// plots, the narrowings and widenings and the branches as tables. It fetches nothing.
GIRTH_EXPORT std::string tubesHtml(const LoadedMesh& loaded, const Tubes& tubes,
                                   std::string_view file);

}  // namespace girth::io
