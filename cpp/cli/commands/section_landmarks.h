// Landmarks of a file: `girth section --landmarks`.
#pragma once

#include <string>
#include <vector>

#include "girth/io/read_mesh.h"
#include "girth/landmarks.h"
#include "model/model_options.h"

namespace girth::cli {

/// The landmarks of a file: a JSON array of objects with `name`, `point` (a vertex, or a point of a
/// face as it is typed), `how`, of distances `to`, and `across` and `all` (girth/landmarks.h).
/// Errors: those of reading; MALFORMED_FILE with the landmark, from 0; those of points, which name
/// the landmark.
Result<std::vector<Landmark>> landmarksOf(const std::string& file, const io::LoadedMesh& loaded,
                                          const std::string& model, const ModelOptions& preparing);

}  // namespace girth::cli
