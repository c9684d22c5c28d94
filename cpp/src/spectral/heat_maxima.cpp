#include "girth/heat_maxima.h"

#include <numeric>

#include "girth/heat_kernel.h"

namespace girth {

Result<std::vector<PersistentMaximum>> persistentHeatMaxima(const SurfaceMesh& mesh,
                                                            const Spectrum& spectrum, double time) {
  const double times[] = {time *
                          std::accumulate(spectrum.areas.begin(), spectrum.areas.end(), 0.0)};
  const auto heat = heatKernelSignature(spectrum, times);
  if (!heat) return heat.error();
  return persistentMaxima(mesh, heat.value().values);
}

}  // namespace girth
