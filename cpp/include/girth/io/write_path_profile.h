// The girth along a path as a file's content: CSV or JSON.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/path_profile.h"

namespace girth::io {

/// `distance,girth,x,y,z,kind,unit` and a row for each place.
GIRTH_EXPORT std::string pathProfileCsv(const LoadedMesh& loaded,
                                        std::span<const PathStation> stations);

/// One JSON object: `file`, `unit`, `length` of the path, and `stations`. Each has `distance`,
/// `girth`, `kind` and `point` (as those of `loopJson`).
GIRTH_EXPORT std::string pathProfileJson(const LoadedMesh& loaded,
                                         std::span<const PathStation> stations,
                                         std::string_view file);

}  // namespace girth::io
