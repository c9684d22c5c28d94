// Models that the benchmarks measure on: files, shapes made here, and finer copies of either.
#pragma once

#include <string>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::bench {

/// A surface and what tables call it.
struct Model {
  std::string name;
  SurfaceMesh mesh;
};

/// Reads a model of any format and prepares it. Named after the file. Ends the program with a
/// message where that fails.
Model loadModel(const std::string& path);

/// A torus whose tube swells and shrinks, of even triangles: the model of benchmarks that run
/// without any files. `faces` is met to within a few per cent.
Model bumpyTorus(Index faces);

/// A shape with exactly `faces` triangles (one more where the parity asks for it): again and
/// again the longest edge is halved, its middle moved by up to 2% of the edge to any side, so that
/// the result is not flat where it was split. Every machine makes an equal mesh. O(n log n).
Model refined(const Model& model, Index faces);

/// `folder/path` where the environment names a folder of models in GIRTH_DATA, otherwise "".
std::string corpusFile(const std::string& path);

/// One model each for about 6,000, 10,000, 50,000, 70,000 and 97,000 faces: well-known ones from
/// the corpus where it is there, otherwise bumpy tori.
std::vector<Model> modelsOfFiveSizes();

}  // namespace girth::bench
