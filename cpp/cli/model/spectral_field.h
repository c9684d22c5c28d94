// The fields of `girth field` that are made of the surface's vibrations: hks, sihks and wks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/spectrum.h"
#include "girth/surface_mesh.h"
#include "model/computed_field.h"
#include "options/option_table.h"

namespace girth::cli {

struct SpectralFieldOptions {
  std::uint32_t pairs{SpectrumOptions{}.pairs};
  /// hks: shares of the surface's area; empty: the one of the persistent heat maxima.
  std::vector<double> times;
  /// hks, sihks, wks: the one number to take, counted from 1; 0: all.
  std::uint32_t component{0};
};

void addSpectralFieldOptions(OptionTable& table, SpectralFieldOptions& options);

/// One field for each number of the signature that is wanted: "wks_1", "wks_2", ...; "hks" where
/// there is one time only. `unit`: of the values. Errors: those of spectrum.h, heat_kernel.h and
/// wave_kernel.h; INVALID_OPTION for a component that there is not.
Result<std::vector<ComputedField>> computeSpectralField(const std::string& field,
                                                        const SpectralFieldOptions& options,
                                                        const std::string& model,
                                                        const SurfaceMesh& mesh,
                                                        const std::string& unit);

}  // namespace girth::cli
