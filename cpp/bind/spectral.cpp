// Fields made of a surface's vibrations.

#include <emscripten/bind.h>

#include <array>
#include <optional>
#include <utility>

#include "boundary.h"
#include "girth/heat_kernel.h"
#include "girth/heat_maxima.h"
#include "girth/spectrum.h"
#include "girth/wave_kernel.h"
#include "maxima.h"
#include "text/number_text.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// A number of JavaScript as a count; what is none becomes 0, which is refused.
Index countOf(const val& number) {
  const double count = number.as<double>();
  return count >= 0 && count < 4e9 ? static_cast<Index>(count) : 0;
}

/// A surface with its spectrum, once that has been asked for.
class SpectralSurface {
 public:
  explicit SpectralSurface(SurfaceMesh mesh) : mesh_(std::move(mesh)) {}

  /// {values} of a `SpectralRequest` of protocol.ts, or an error.
  val field(const val& request, const val& onProgress) {
    return guarded([&] {
      if (auto error = prepare(request, onProgress)) return toJs(*error);
      const std::string name = request["name"].as<std::string>();
      const Result<VertexSignatures> signatures = signaturesOf(name, request);
      if (!signatures) return toJs(signatures.error());
      const std::size_t dimensions = signatures.value().dimensions;
      // Counted from 1, as the command does. Only one time was asked for.
      const std::size_t component = name == "hks" ? 1 : countOf(request["component"]);
      if (component < 1 || component > dimensions) {
        return toJs(
            makeError(ErrorCode::InvalidOption, -1,
                      name + " has " + std::to_string(dimensions) + " components, counted from 1"));
      }
      std::vector<double> values(mesh_.vertexCount());
      for (std::size_t v = 0; v < values.size(); ++v) {
        values[v] = signatures.value().values[v * dimensions + component - 1];
      }
      val result = val::object();
      result.set("values", copyOut<double>("Float64Array", values));
      std::string method = std::to_string(spectrum_->values.size()) + " eigenpairs";
      if (name == "hks") method += ", time " + io::formatNumber(request["time"].as<double>());
      result.set("method", method);
      return result;
    });
  }

  /// {maxima}, each a `Maximum` of types.ts, or an error.
  val heatMaxima(const val& request, const val& onProgress) {
    return guarded([&] {
      if (auto error = prepare(request, onProgress)) return toJs(*error);
      const auto found = persistentHeatMaxima(mesh_, *spectrum_, request["time"].as<double>());
      if (!found) return toJs(found.error());
      return describe(found.value());
    });
  }

  /// Lets go of the spectrum.
  void forget() { spectrum_.reset(); }

 private:
  /// Computes the spectrum, unless it is there.
  std::optional<Error> prepare(const val& request, const val& onProgress) {
    const Index pairs = countOf(request["pairs"]);
    if (spectrum_ && pairs == pairs_) return std::nullopt;
    spectrum_.reset();
    Result<Spectrum> spectrum = laplaceSpectrum(mesh_, {pairs}, reportingTo(onProgress));
    if (!spectrum) return spectrum.error();
    spectrum_ = std::move(spectrum).value();
    pairs_ = pairs;
    return std::nullopt;
  }

  Result<VertexSignatures> signaturesOf(const std::string& name, const val& request) const {
    if (name == "wks") return waveKernelSignature(*spectrum_);
    if (name == "sihks") return scaleInvariantHeatKernelSignature(*spectrum_);
    if (name != "hks") return makeError(ErrorCode::Usage, -1, "there is no field '" + name + "'");
    const std::array<double, 1> times{request["time"].as<double>() * mesh_.area()};
    return heatKernelSignature(*spectrum_, times);
  }

  SurfaceMesh mesh_;
  Index pairs_{0};
  std::optional<Spectrum> spectrum_;
};

/// {surface} of a prepared surface's arrays, or an error; the surface is the caller's to delete.
val spectralSurface(const val& arrays) {
  return guarded([&] {
    Result<SurfaceMesh> mesh = surfaceOf(arrays);
    if (!mesh) return toJs(mesh.error());
    val result = val::object();
    result.set("surface", std::make_shared<SpectralSurface>(std::move(mesh).value()));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthSpectral) {
  emscripten::class_<SpectralSurface>("SpectralSurface")
      .smart_ptr<std::shared_ptr<SpectralSurface>>("SpectralSurfacePointer")
      .function("field", &SpectralSurface::field)
      .function("heatMaxima", &SpectralSurface::heatMaxima)
      .function("forget", &SpectralSurface::forget);
  emscripten::function("spectralSurface", &spectralSurface);
}

}  // namespace
}  // namespace girth::bind
