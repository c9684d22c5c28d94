// Harmonic functions: those whose value at each vertex is a mean of the neighbours' values.
#pragma once

#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::spectral {

/// The value of a function at a vertex.
struct FixedValue {
  Vertex vertex;
  double value{0};
};

/// The harmonic function with some values given, all other vertices being means of their
/// neighbours with positive weights: half the sum of the cotangents opposite to an edge, and at
/// least a thousandth. So between the given values there is no local maximum and no minimum. NaN in
/// components without a given value. Empty where the equations cannot be solved. About O(n^1.5).
std::vector<double> harmonicFunction(const SurfaceMesh& mesh, std::span<const FixedValue> fixed);

}  // namespace girth::spectral
