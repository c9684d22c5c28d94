// Models read from files.
#pragma once

#include <string>

#include "girth/io/read_mesh.h"
#include "model/model_options.h"

namespace girth::cli {

/// Reads and prepares a model. Errors: those of readFile and io::readMesh, USAGE.
Result<io::LoadedMesh> loadModel(const std::string& path, const ModelOptions& options);

/// A surface read for a study: all its components, open edges as boundaries. Errors: those of
/// readFile and io::readMesh.
Result<SurfaceMesh> readSurface(const std::string& path);

}  // namespace girth::cli
