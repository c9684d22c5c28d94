// Arguments of the functions that compute and write tips, limbs and parts.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "boundary.h"
#include "girth/limbs.h"
#include "girth/parts.h"
#include "girth/print_check.h"
#include "girth/tips.h"

namespace girth::bind {

/// {girth, diameter}: one value of each for every vertex.
struct GirthAndDiameter {
  std::vector<double> girth, diameter;

  explicit GirthAndDiameter(const emscripten::val& fields)
      : girth(copyIn<double>(fields["girth"])), diameter(copyIn<double>(fields["diameter"])) {}
};

/// The limbs of all tips by the girth. `stations` as JavaScript gives it.
inline Result<Limbs> limbsByGirth(const SurfaceMesh& mesh, const std::vector<double>& girth,
                                  double stations, const ExecutionContext& context) {
  const Result<Tips> tips = findTips(mesh, girth);
  if (!tips) return tips.error();
  const bool isNumber = stations >= 0 && stations <= 4e9;
  const LimbOptions options{isNumber ? static_cast<Index>(stations) : 0};
  return findLimbs(mesh, girth, tips.value().tips, options, context);
}

/// `PartOptions` of types.ts.
inline PartOptions partOptionsOf(const emscripten::val& options) {
  return {{options["girth"].as<double>(), options["thickness"].as<double>()},
          options["smoothing"].as<double>()};
}

/// `PrintLimits` of types.ts, complete.
inline PrintLimits limitsOf(const emscripten::val& limits) {
  return {limits["tubeDiameter"].as<double>(), limits["wallThickness"].as<double>(),
          limits["gap"].as<double>()};
}

/// The check of limits by {girth, thickness}, either of which may be empty.
inline Result<PrintCheck> printCheckOf(const SurfaceMesh& mesh, const emscripten::val& fields,
                                       const PrintLimits& limits, const ExecutionContext& context) {
  const auto girth = copyIn<double>(fields["girth"]),
             thickness = copyIn<double>(fields["thickness"]);
  return checkPrint(mesh, {girth, thickness}, limits, {}, context);
}

}  // namespace girth::bind
