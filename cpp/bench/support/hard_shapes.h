// Shapes that an engine of geodesics may crawl on, made by code, and smooth ones to compare with.
#pragma once

#include <string>
#include <vector>

#include "girth/triangle_soup.h"

namespace girth::bench {

/// A model, and what tables call it.
struct HardShape {
  std::string name;
  TriangleSoup soup;
};

/// Rounded surfaces of even triangles: what the engine is made for.
std::vector<HardShape> smoothShapes();

/// Poles of high valence, needles, doubled and flat plates, surfaces of revolution, very unequal
/// edges and components, far from the origin, and others with much that ties.
std::vector<HardShape> hardShapes();

}  // namespace girth::bench
