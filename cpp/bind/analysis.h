// Arguments and results of the functions that compute and write tips, limbs and parts.
#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <vector>

#include "boundary.h"
#include "girth/describe/tips.h"
#include "girth/limbs.h"
#include "girth/parts.h"
#include "girth/print_check.h"
#include "girth/tips.h"
#include "result_object.h"
#include "surface_point.h"

namespace girth::bind {

/// {girth, diameter}: one value of each for every vertex.
struct GirthAndDiameter {
  std::vector<double> girth, diameter;

  explicit GirthAndDiameter(const emscripten::val& fields)
      : girth(copyIn<double>(fields["girth"])), diameter(copyIn<double>(fields["diameter"])) {}
};

/// `FoundTips` of protocol.ts: lines have drawn positions alone, so their exact points go with
/// them.
inline emscripten::val tipsWithPoints(const DrawnSurface& surface, const Tips& tips) {
  std::vector<SurfacePoint> points;
  const auto add = [&](const ContourLine& line) {
    points.insert(points.end(), line.points.begin(), line.points.end());
  };
  for (const Tip& tip : tips.tips) std::for_each(tip.contour.begin(), tip.contour.end(), add);
  for (const OpenArc& arc : tips.arcs) add(arc.line);
  emscripten::val result = ResultObject(surface).addMembers(tips).object();
  result.set("linePoints", packedPoints(points));
  return result;
}

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
  return {{options["girth"].as<double>(), options["shapeDiameter"].as<double>()},
          options["smoothing"].as<double>()};
}

/// The kinds of vertices as Uint8Array.
inline emscripten::val kindCodes(const std::vector<PartKind>& kinds) {
  std::vector<std::uint8_t> codes;
  for (const PartKind kind : kinds) codes.push_back(static_cast<std::uint8_t>(kind));
  return copyOut<std::uint8_t>("Uint8Array", codes);
}

/// Kinds that `kindCodes` made codes of, again.
inline std::vector<PartKind> kindsAgain(const emscripten::val& codes) {
  std::vector<PartKind> kinds;
  for (const std::uint8_t code : copyIn<std::uint8_t>(codes)) {
    kinds.push_back(static_cast<PartKind>(code));
  }
  return kinds;
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
