// Arguments of the functions that compute and write tips and parts.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "boundary.h"
#include "girth/parts.h"

namespace girth::bind {

/// {girth, diameter}: one value of each for every vertex.
struct GirthAndDiameter {
  std::vector<double> girth, diameter;

  explicit GirthAndDiameter(const emscripten::val& fields)
      : girth(copyIn<double>(fields["girth"])), diameter(copyIn<double>(fields["diameter"])) {}
};

/// `PartOptions` of types.ts.
inline PartOptions partOptionsOf(const emscripten::val& options) {
  return {{options["girth"].as<double>(), options["diameter"].as<double>()},
          options["smoothing"].as<double>()};
}

/// `PrintLimits` of types.ts.
inline PrintLimits limitsOf(const emscripten::val& limits) {
  return {limits["tubeDiameter"].as<double>(), limits["wallThickness"].as<double>()};
}

/// The weak places, or why the surface cannot be checked.
inline Result<std::vector<WeakPlace>> checkedPlaces(const SurfaceMesh& mesh,
                                                    const GirthAndDiameter& values,
                                                    const PrintLimits& limits) {
  if (auto error = whyNotChecked(mesh, values.diameter, limits)) return *std::move(error);
  return findWeakPlaces(mesh, values.girth, values.diameter, limits);
}

}  // namespace girth::bind
