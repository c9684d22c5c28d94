// How much of a surface belongs to each vertex.
#pragma once

#include <vector>

#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The mixed Voronoi area of every vertex (Meyer, Desbrun, Schröder and Barr 2003): what is nearer
/// to it than to the other corners of its faces; of a face with an obtuse angle, half for the
/// obtuse corner and a quarter for each of the others. In squared model units; they add up to
/// `mesh.area()`. The weights of all distributions and means over vertices
/// (web/docs/definitions.md, section 6).
GIRTH_EXPORT std::vector<double> vertexAreas(const SurfaceMesh& mesh);

}  // namespace girth
