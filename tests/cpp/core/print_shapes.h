// Shapes of known thickness, drawn by formula, for the print check.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "shapes.h"

namespace girth::test {

/// The boundary of the cells of a grid that `isFilled(i, j, k)` says yes to; a square is two
/// triangles. The grid's planes are at `xs`, `ys` and `zs`. Cells may not meet along an edge only.
Shape blocks(const std::vector<double>& xs, const std::vector<double>& ys,
             const std::vector<double>& zs, const std::function<bool(int, int, int)>& isFilled);

/// A profile of points (distance from the axis, height), turned round the z axis in `around` steps.
/// From the axis to the axis with the axis on its left going up, or closed and counter-clockwise.
Shape revolved(const std::vector<std::pair<double, double>>& profile, Index around);

/// Its faces turned over.
Shape turnedOver(Shape shape);

/// A shape, and the truth about it.
struct PrintShape {
  std::string name;
  Shape shape;
  /// The least thickness of its walls.
  double wall;
  /// The least clearance between its surfaces; infinite where there is none.
  double gap;
  /// By what share of the truth the check may read less: facets in the place of curves.
  double tolerance{1e-9};
  /// The measure that the check reads where it reads less on purpose; 0 otherwise.
  double reads{0};
};

/// At least thirty of them.
std::vector<PrintShape> printShapes();

}  // namespace girth::test
