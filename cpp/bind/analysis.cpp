// Tips, limbs, parts, maxima and weak places of a surface, and the areas of its vertices.

#include "analysis.h"

#include <emscripten/bind.h>

#include <cmath>
#include <utility>

#include "girth/limbs.h"
#include "girth/tips.h"
#include "girth/vertex_areas.h"
#include "job_surface.h"
#include "maxima.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `ContourLine` of types.ts.
val lineOf(const JobSurface& surface, const ContourLine& line) {
  std::vector<Vec3> points;
  points.reserve(line.points.size());
  for (const SurfacePoint& point : line.points) {
    points.push_back(positionOf(surface.mesh(), point));
  }
  val result = val::object();
  result.set("closed", line.closed);
  result.set("polyline", drawnPoints(points, surface.origin()));
  return result;
}

/// `Tip` of types.ts.
val tipOf(const JobSurface& surface, const Tip& tip) {
  val contour = val::array();
  for (const ContourLine& line : tip.contour) contour.call<void>("push", lineOf(surface, line));
  val result = val::object();
  result.set("vertices", copyOut<Index>("Uint32Array", numbersOf(tip.vertices)));
  result.set("contour", contour);
  result.set("area", tip.area);
  result.set("boundaryLength", tip.boundaryLength);
  result.set("apex", Index{tip.apex});
  result.set("apexDistance", tip.apexDistance);
  result.set("jump", tip.jump);
  return result;
}

/// A vertex, or -1.
double vertexOf(Vertex vertex) { return vertex == Vertex::none ? -1 : static_cast<double>(vertex); }

/// `Part` of types.ts.
val partOf(const Part& part) {
  val result = val::object();
  result.set("kind", std::string(toString(part.kind)));
  result.set("vertices", copyOut<Index>("Uint32Array", numbersOf(part.vertices)));
  result.set("area", part.area);
  result.set("medianGirth", part.medianGirth);
  result.set("medianThickness", part.medianThickness);
  result.set("thinnest", vertexOf(part.thinnest));
  result.set("equivalentRadius", part.equivalentRadius());
  return result;
}

/// {areas} of the vertices, or an error.
val areasOfVertices(const JobSurface& surface) {
  return guarded([&] {
    val result = val::object();
    result.set("areas", copyOut<double>("Float64Array", vertexAreas(surface.mesh())));
    return result;
  });
}

/// `Tips` of types.ts, or an error.
val tips(const JobSurface& surface, const val& girth) {
  return guarded([&] {
    const Result<Tips> found = findTips(surface.mesh(), copyIn<double>(girth));
    if (!found) return toJs(found.error());
    val regions = val::array(), arcs = val::array();
    for (const Tip& tip : found.value().tips) regions.call<void>("push", tipOf(surface, tip));
    for (const OpenArc& arc : found.value().arcs) {
      val entry = val::object();
      entry.set("line", lineOf(surface, arc.line));
      entry.set("length", arc.length);
      entry.set("jump", arc.jump);
      arcs.call<void>("push", entry);
    }
    val result = val::object();
    result.set("tips", regions);
    result.set("arcs", arcs);
    result.set("crossedEdges", found.value().crossedEdges);
    return result;
  });
}

/// `Limb` of types.ts.
val limbOf(const Limb& limb) {
  val profile = val::array();
  for (const GirthStation& station : limb.profile) {
    val entry = val::object();
    entry.set("distance", station.distance);
    entry.set("ring", station.ring);
    entry.set("median", station.median);
    entry.set("least", station.least);
    if (!std::isnan(station.least)) entry.set("place", faceWithWeights(station.place));
    profile.call<void>("push", entry);
  }
  val numbers = val::array();
  for (const Index tip : limb.tips) numbers.call<void>("push", tip);
  val result = val::object();
  result.set("apex", Index{limb.apex});
  result.set("tips", numbers);
  result.set("length", limb.length);
  result.set("end", std::string(toString(limb.end)));
  result.set("narrowest", limb.narrowest);
  result.set("narrowestDistance", limb.narrowestDistance);
  result.set("median", limb.median);
  result.set("base", limb.base);
  result.set("vertices", copyOut<Index>("Uint32Array", numbersOf(limb.vertices)));
  result.set("distances", copyOut<double>("Float64Array", limb.distances));
  result.set("profile", profile);
  return result;
}

/// `Limbs` of types.ts, or an error.
val limbs(const JobSurface& surface, const val& girth, double stations, const val& onProgress) {
  return guarded([&] {
    const Result<Limbs> found =
        limbsByGirth(surface.mesh(), copyIn<double>(girth), stations, reportingTo(onProgress));
    if (!found) return toJs(found.error());
    val list = val::array(), without = val::array();
    for (const Limb& limb : found.value().limbs) list.call<void>("push", limbOf(limb));
    for (const Index tip : found.value().tipsWithoutLimb) without.call<void>("push", tip);
    val result = val::object();
    result.set("limbs", list);
    result.set("tipsWithoutLimb", without);
    return result;
  });
}

/// {girth, thickness}, or an error.
val thresholds(const JobSurface& surface, const val& fields) {
  return guarded([&] {
    const GirthAndDiameter values(fields);
    const PartThresholds found = suggestedThresholds(surface.mesh(), values.girth, values.diameter);
    val result = val::object();
    result.set("girth", found.girth);
    result.set("thickness", found.thickness);
    return result;
  });
}

/// `Parts` of types.ts, or an error.
val parts(const JobSurface& surface, const val& fields, const val& options) {
  return guarded([&] {
    const GirthAndDiameter values(fields);
    const Result<Parts> found =
        findParts(surface.mesh(), values.girth, values.diameter, partOptionsOf(options));
    if (!found) return toJs(found.error());
    std::vector<std::uint8_t> kinds;
    for (const PartKind kind : found.value().kinds) {
      kinds.push_back(static_cast<std::uint8_t>(kind));
    }
    val list = val::array();
    for (const Part& part : found.value().parts) list.call<void>("push", partOf(part));
    val result = val::object();
    result.set("kinds", copyOut<std::uint8_t>("Uint8Array", kinds));
    result.set("partOf", copyOut<Index>("Uint32Array", found.value().partOf));
    result.set("parts", list);
    return result;
  });
}

/// {maxima} of the values, or of their negatives, or an error.
val maxima(const JobSurface& surface, const val& values, bool minima) {
  return guarded([&] {
    std::vector<double> heights = copyIn<double>(values);
    const double sign = minima ? -1 : 1;
    for (double& height : heights) height *= sign;
    auto found = persistentMaxima(surface.mesh(), heights);
    if (!found) return toJs(found.error());
    for (PersistentMaximum& maximum : found.value()) maximum.value *= sign;
    return describe(found.value());
  });
}

/// `WeakPlace` of types.ts.
val placeOf(const WeakPlace& place) {
  val entry = val::object();
  entry.set("kind", std::string(toString(place.kind)));
  entry.set("vertices", copyOut<Index>("Uint32Array", numbersOf(place.vertices)));
  entry.set("faces", copyOut<Index>("Uint32Array", numbersOf(place.faces)));
  entry.set("area", place.area);
  entry.set("least", place.least);
  entry.set("thinnest", surfacePointOf(place.thinnest));
  if (place.kind != WeakKind::Tube) {
    entry.set("opposite", tripleOf(place.opposite));
  }
  return entry;
}

/// `PrintCheck` of types.ts, or an error.
val printCheck(const JobSurface& surface, const val& fields, const val& limits,
               const val& onProgress) {
  return guarded([&] {
    const auto found =
        printCheckOf(surface.mesh(), fields, limitsOf(limits), reportingTo(onProgress));
    if (!found) return toJs(found.error());
    val places = val::array();
    for (const WeakPlace& place : found.value().places) {
      places.call<void>("push", placeOf(place));
    }
    val result = val::object();
    result.set("places", places);
    result.set("failingShare", found.value().failingShare);
    result.set("passingScale", found.value().passingScale);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthAnalysis) {
  emscripten::function("vertexAreas", &areasOfVertices);
  emscripten::function("tips", &tips);
  emscripten::function("limbs", &limbs);
  emscripten::function("suggestedThresholds", &thresholds);
  emscripten::function("parts", &parts);
  emscripten::function("maxima", &maxima);
  emscripten::function("printCheck", &printCheck);
}

}  // namespace
}  // namespace girth::bind
