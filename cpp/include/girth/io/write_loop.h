// A geodesic loop as a file's content: JSON, OBJ, CSV or GLB.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/girth_solver.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// One line of JSON: `file`, `vertex` (the base's number in the file; null where the base is none),
/// `length`, `kind`, `angle` in radians, `unit`, and as points `base`, `midpoint` and, if wanted,
/// `points`: each with its `position` and the `vertices` of the file (one, the two of an edge, or
/// the three of a face) that it lies between, with their `weights`. `persistence`: tau, where the
/// loop is that of I_tau; behind `unit`, where it is not 0.
GIRTH_EXPORT std::string loopJson(const LoadedMesh& loaded, const GirthLoop& loop,
                                  std::string_view file, bool withPoints, double persistence = 0);

/// The polyline as an OBJ line element, closed.
GIRTH_EXPORT std::string loopObj(const LoadedMesh& loaded, const GirthLoop& loop);

/// `x,y,z` and one row for every point of the polyline; the last equals the first.
GIRTH_EXPORT std::string loopCsv(const LoadedMesh& loaded, const GirthLoop& loop);

/// The polyline as GLB: a line strip (mode 3) with positions rounded to floats; in the mesh's
/// `extras` the loop's `length`, `kind`, `angle` and `unit`. glTF is in metres, as in fieldGlb.
/// Error: EMPTY_MESH where the loop is unresolved and has no points.
GIRTH_EXPORT Result<std::string> loopGlb(const LoadedMesh& loaded, const GirthLoop& loop);

}  // namespace girth::io
