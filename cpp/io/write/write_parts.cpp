#include "girth/io/write_parts.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string vertexJson(const LoadedMesh& loaded, Index vertex) {
  return vertex == kNoIndex ? "null" : pointJson(loaded, SurfacePoint::atVertex(Vertex(vertex)));
}

std::string partJson(const LoadedMesh& loaded, const Part& part) {
  std::string text = "{\"kind\":" + jsonString(toString(part.kind)) +
                     ",\"area\":" + formatNumber(part.area) +
                     ",\"medianGirth\":" + numberJson(part.medianGirth) +
                     ",\"medianThickness\":" + numberJson(part.medianThickness);
  if (part.kind == PartKind::Tube) {
    text += ",\"equivalentRadius\":" + numberJson(part.equivalentRadius());
  }
  return text + ",\"thinnest\":" + vertexJson(loaded, part.thinnest) +
         ",\"vertices\":" + inputsJson(loaded, part.vertices) + "}";
}

std::string_view measureOf(WeakKind kind) {
  switch (kind) {
    case WeakKind::Tube:
      return "diameter";
    case WeakKind::Wall:
      return "thickness";
    case WeakKind::Gap:
      break;
  }
  return "clearance";
}

std::string placeJson(const LoadedMesh& loaded, const WeakPlace& place) {
  std::string text = "{\"kind\":" + jsonString(toString(place.kind)) +
                     ",\"measure\":" + jsonString(measureOf(place.kind)) +
                     ",\"least\":" + formatNumber(place.least) +
                     ",\"area\":" + formatNumber(place.area) +
                     ",\"thinnest\":" + pointJson(loaded, place.thinnest);
  if (place.kind != WeakKind::Tube) {
    text += ",\"opposite\":[" + pointText(place.opposite, ',') + "]";
  }
  return text + ",\"vertices\":" + inputsJson(loaded, place.vertices) + "}";
}

}  // namespace

std::string partsJson(const LoadedMesh& loaded, const Parts& parts, const PartOptions& options,
                      std::string_view file, double persistence) {
  std::string text = modelJson(file, loaded) + persistenceJson(persistence) +
                     ",\"thresholds\":{\"girth\":" + numberJson(options.thresholds.girth) +
                     ",\"thickness\":" + numberJson(options.thresholds.thickness) +
                     "},\"smoothing\":" + formatNumber(options.smoothing) + ",\"parts\":[";
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + partJson(loaded, parts.parts[i]);
  }
  return text + "]}\n";
}

std::string printCheckJson(const LoadedMesh& loaded, const PrintCheck& check,
                           const PrintLimits& limits, std::string_view file, double persistence) {
  std::string text = modelJson(file, loaded) + persistenceJson(persistence) +
                     ",\"limits\":{\"tubeDiameter\":" + formatNumber(limits.tubeDiameter) +
                     ",\"wallThickness\":" + formatNumber(limits.wallThickness) +
                     ",\"gap\":" + formatNumber(limits.gap) +
                     "},\"passes\":" + (check.places.empty() ? "true" : "false") +
                     ",\"failingShare\":" + formatNumber(check.failingShare) +
                     ",\"passingScale\":" + numberJson(check.passingScale) + ",\"places\":[";
  for (std::size_t i = 0; i < check.places.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + placeJson(loaded, check.places[i]);
  }
  return text + "]}\n";
}

}  // namespace girth::io
