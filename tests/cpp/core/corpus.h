// Models from outside the repository, in a folder that the environment variable GIRTH_DATA names.
#pragma once

#include <string>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::test {

/// Whether there is such a folder.
bool corpusIsThere();

/// Names of the models that are closed and have at most so many faces, in the order of the
/// alphabet.
std::vector<std::string> corpusModels(Index mostFaces);

/// A model, OBJ or OFF; fails the test if it cannot be read.
SurfaceMesh corpusModel(const std::string& name);

}  // namespace girth::test
