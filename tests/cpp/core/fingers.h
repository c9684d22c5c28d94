// Bodies with fingers of known girth: prisms that stand on a box, straight or bent.
#pragma once

#include <vector>

#include "shapes.h"

namespace girth::test {

/// A square prism that leaves the body upwards and is bent in mitred joints, so that every straight
/// section is a prism of the same width.
struct Finger {
  double length{4};           ///< along its axis, in widths
  std::vector<double> bends;  ///< angles in radians, at equal distances along the axis
};

/// A box with one row of fingers on its top, a width apart, numbered along the row. Their width is
/// 1 and so their girth 4; each side of a finger is divided into `cells`, its sections are as far
/// apart.
Shape fingersOnBox(const std::vector<Finger>& fingers, Index cells);

/// The corners of a finger's base, four vertices, as `fingersOnBox` numbers them.
std::vector<Vertex> baseCorners(const SurfaceMesh& mesh, std::size_t finger);

}  // namespace girth::test
