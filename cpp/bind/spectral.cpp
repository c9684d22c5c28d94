// Fields and maxima that are computed from a surface's spectrum.

#include <emscripten/bind.h>

#include <array>
#include <optional>
#include <string>

#include "boundary.h"
#include "girth/fields.h"
#include "girth/heat_maxima.h"
#include "maxima.h"
#include "studies_surface.h"
#include "text/number_text.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A number of JavaScript as a count. Anything else becomes 0, which is refused.
Index countOf(const val& number, Index byDefault) {
  if (number.isUndefined()) return byDefault;
  const double count = number.as<double>();
  return count >= 0 && count < 4e9 ? static_cast<Index>(count) : 0;
}

/// As a share of the area.
double timeOf(const val& request) {
  const val time = request["time"];
  return time.isUndefined() ? kHeatMaximaTime : time.as<double>();
}

/// The number of its signature that a field is by default, from 1.
Index usualNumber(std::string_view name) {
#define GIRTH_SPECTRAL_FIELD(field, unit, title, listTitle, meaning, signature, number, count) \
  if (name == #field) return number;
#include "girth/fields.def"
  return 1;
}

/// Computes what a `SpectralRequest` of protocol.ts needs.
std::optional<Error> prepare(StudiesSurface& surface, const val& request, const val& onProgress) {
  return surface.prepareSpectrum(countOf(request["pairs"], SpectrumOptions{}.pairs),
                                 reportingTo(onProgress));
}

/// {values, method} of a `SpectralRequest` of protocol.ts, or an error.
val spectralField(StudiesSurface& surface, const val& request, const val& onProgress) {
  return guarded([&] {
    if (const auto error = prepare(surface, request, onProgress)) return toJs(*error);
    const std::string name = request["name"].as<std::string>();
    const double time = timeOf(request);
    const std::array<double, 1> times{time * surface.mesh().area()};
    const Result<VertexSignatures> signatures = fieldSignature(surface.spectrum(), name, times);
    if (!signatures) return toJs(signatures.error());
    const std::size_t dimensions = signatures.value().dimensions;
    // Counted from 1, as in the command. 'hks' is computed at one time only.
    const std::size_t component =
        name == "hks" ? 1 : countOf(request["component"], usualNumber(name));
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
    if (name == "hks") method += ", time " + io::formatNumber(time);
    result.set("method", method);
    return result;
  });
}

/// {maxima}, each a `Maximum` of types.ts, or an error.
val heatMaxima(StudiesSurface& surface, const val& request, const val& onProgress) {
  return guarded([&] {
    if (const auto error = prepare(surface, request, onProgress)) return toJs(*error);
    const auto found = persistentHeatMaxima(surface.mesh(), surface.spectrum(), timeOf(request));
    if (!found) return toJs(found.error());
    return maximaOf(found.value());
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
