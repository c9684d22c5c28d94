// How much of a face belongs to one of its corners.
#pragma once

namespace girth {

/// The mixed Voronoi share (Meyer, Desbrun, Schröder and Barr 2003) of a corner in a face of the
/// given area. `a`: squared length of the side opposite to the corner; `b`, `c`: of the others.
inline double voronoiShare(double area, double a, double b, double c) {
  if (a > b + c) return area / 2;
  if (b > a + c || c > a + b) return area / 4;
  // (b cot B + c cot C) / 8, with cot B = (a + c − b) / (4 · area).
  const double part = 32 * area;
  return b / part * (a + c - b) + c / part * (a + b - c);
}

}  // namespace girth
