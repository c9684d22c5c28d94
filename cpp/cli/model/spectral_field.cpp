#include "model/spectral_field.h"

#include <numeric>

#include "girth/fields.h"
#include "girth/heat_maxima.h"
#include "process/progress_line.h"
#include "text/number_text.h"

namespace girth::cli {
void addSpectralFieldOptions(OptionTable& table, SpectralFieldOptions& options) {
  table
      .add("--pairs N", options.pairs,
           "hks, sihks, wks: pairs of eigenvalues and -functions; " +
               std::to_string(options.pairs) + " by default")
      .range(2, 100'000)
      .onlyFor("--field", {"hks", "sihks", "wks"});
  table
      .add("--time T,T,...", options.times,
           "hks: diffusion times as shares of the area; " + io::formatNumber(kHeatMaximaTime) +
               " by default")
      .separated()
      .range(0, 1e6)
      .onlyFor("--field", {"hks"});
  table
      .add("--only N", options.component,
           "hks, sihks, wks: one number of each vertex's only, counted from 1")
      .range(1, 100'000)
      .onlyFor("--field", {"hks", "sihks", "wks"});
}

Result<std::vector<ComputedField>> computeSpectralField(const std::string& field,
                                                        const SpectralFieldOptions& options,
                                                        const std::string& model,
                                                        const SurfaceMesh& mesh,
                                                        const std::string& unit) {
  ProgressLine progress(model);
  const ExecutionContext context = watched(0, progress);
  const auto spectrum = laplaceSpectrum(mesh, {options.pairs}, context);
  if (!spectrum) return spectrum.error();
  const std::vector<double> shares =
      options.times.empty() ? std::vector<double>{kHeatMaximaTime} : options.times;
  const std::vector<double>& areas = spectrum.value().areas;
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<double> times;
  for (const double share : shares) times.push_back(share * area);
  const auto signature = fieldSignature(spectrum.value(), field, times);
  if (!signature) return signature.error();

  const std::size_t dimensions = signature.value().dimensions;
  if (options.component > dimensions) {
    return makeError(ErrorCode::InvalidOption, -1,
                     field + " has " + std::to_string(dimensions) + " components, counted from 1");
  }
  const std::string pairs = std::to_string(spectrum.value().values.size()) + " eigenpairs";
  std::vector<ComputedField> fields;
  for (std::size_t d = 0; d < dimensions; ++d) {
    if (options.component != 0 && d + 1 != options.component) continue;
    ComputedField one;
    one.name = dimensions == 1 ? field : field + "_" + std::to_string(d + 1);
    one.method = field == "hks" ? pairs + ", time " + io::formatNumber(shares[d]) : pairs;
    one.unit = unit;
    for (const Vertex v : mesh.vertices()) {
      one.values.push_back(signature.value().values[v * dimensions + d]);
    }
    fields.push_back(std::move(one));
  }
  return fields;
}

}  // namespace girth::cli
