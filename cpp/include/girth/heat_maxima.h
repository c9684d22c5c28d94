// Persistent heat maxima: where a shape ends, as the heat kernel sees it.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/persistent_maxima.h"
#include "girth/spectrum.h"
#include "girth/surface_mesh.h"

namespace girth {

/// As a share of the surface's area: heat spreads over some 9% of the root of the area, and of 300
/// pairs the last has all but vanished.
inline constexpr double kHeatMaximaTime = 2e-3;

/// The maxima of the heat kernel signature at a small time, ranked by persistence (Dey, Li, Luo,
/// Ranjan, Safa and Wang 2010): heat stays longest where little surface is near, at tips. The
/// paper's Figure 13 compares them with the girth's tips (tips.h). The user has to state how many,
/// or what persistence, make a tip.
///
/// `time`: a share of the surface's area. Values and persistence are in 1 / squared model units.
/// Errors: INVALID_OPTION for a time that is negative or not finite; USAGE for a spectrum that is
/// not the surface's.
GIRTH_EXPORT Result<std::vector<PersistentMaximum>> persistentHeatMaxima(
    const SurfaceMesh& mesh, const Spectrum& spectrum, double time = kHeatMaximaTime);

}  // namespace girth
