// Fields and maxima that are computed from a surface's spectrum.

#include <emscripten/bind.h>

#include <array>
#include <optional>
#include <string>

#include "boundary.h"
#include "girth/heat_kernel.h"
#include "girth/heat_maxima.h"
#include "girth/wave_kernel.h"
#include "maxima.h"
#include "studies_surface.h"
#include "text/number_text.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A number of JavaScript as a count. What is no count becomes 0, which is refused.
Index countOf(const val& number) {
  const double count = number.as<double>();
  return count >= 0 && count < 4e9 ? static_cast<Index>(count) : 0;
}

/// Computes what a `SpectralRequest` of protocol.ts needs.
std::optional<Error> prepare(StudiesSurface& surface, const val& request, const val& onProgress) {
  return surface.prepareSpectrum(countOf(request["pairs"]), reportingTo(onProgress));
}

Result<VertexSignatures> signaturesOf(const StudiesSurface& surface, const std::string& name,
                                      const val& request) {
  if (name == "wks") return waveKernelSignature(surface.spectrum());
  if (name == "sihks") return scaleInvariantHeatKernelSignature(surface.spectrum());
  if (name != "hks") return makeError(ErrorCode::Usage, -1, "there is no field '" + name + "'");
  const std::array<double, 1> times{request["time"].as<double>() * surface.mesh().area()};
  return heatKernelSignature(surface.spectrum(), times);
}

/// {values, method} of a `SpectralRequest` of protocol.ts, or an error.
val spectralField(StudiesSurface& surface, const val& request, const val& onProgress) {
  return guarded([&] {
    if (const auto error = prepare(surface, request, onProgress)) return toJs(*error);
    const std::string name = request["name"].as<std::string>();
    const Result<VertexSignatures> signatures = signaturesOf(surface, name, request);
    if (!signatures) return toJs(signatures.error());
    const std::size_t dimensions = signatures.value().dimensions;
    // Counted from 1, as in the command. 'hks' is computed at one time only.
    const std::size_t component = name == "hks" ? 1 : countOf(request["component"]);
    if (component < 1 || component > dimensions) {
      return toJs(
          makeError(ErrorCode::InvalidOption, -1,
                    name + " has " + std::to_string(dimensions) + " components, counted from 1"));
    }
    std::vector<double> values(surface.mesh().vertexCount());
    for (std::size_t v = 0; v < values.size(); ++v) {
      values[v] = signatures.value().values[v * dimensions + component - 1];
    }
    val result = val::object();
    result.set("values", copyOut<double>("Float64Array", values));
    std::string method = std::to_string(surface.spectrum().values.size()) + " eigenpairs";
    if (name == "hks") method += ", time " + io::formatNumber(request["time"].as<double>());
    result.set("method", method);
    return result;
  });
}

/// {maxima}, each a `Maximum` of types.ts, or an error.
val heatMaxima(StudiesSurface& surface, const val& request, const val& onProgress) {
  return guarded([&] {
    if (const auto error = prepare(surface, request, onProgress)) return toJs(*error);
    const auto found =
        persistentHeatMaxima(surface.mesh(), surface.spectrum(), request["time"].as<double>());
    if (!found) return toJs(found.error());
    return describe(found.value());
  });
}

EMSCRIPTEN_BINDINGS(girthSpectral) {
  emscripten::class_<StudiesSurface>("Surface").smart_ptr<std::shared_ptr<StudiesSurface>>(
      "SurfacePointer");
  emscripten::function("exactSurface", &exactSurface<StudiesSurface>);
  emscripten::function("spectralField", &spectralField);
  emscripten::function("heatMaxima", &heatMaxima);
}

}  // namespace
}  // namespace girth::bind
