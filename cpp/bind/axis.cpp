// The axis of a limb or another tube, with the loops along it.

#include <emscripten/bind.h>

#include <limits>
#include <vector>

#include "boundary.h"
#include "described.h"
#include "girth/describe/limb_axis.h"
#include "job_surface.h"
#include "result_object.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// The stations that the axis needs, of `GirthStation[]` of types.ts.
GirthProfile stationsOf(const val& stations) {
  GirthProfile profile;
  for (unsigned i = 0; i < stations["length"].as<unsigned>(); ++i) {
    GirthStation station;
    station.distance = stations[i]["distance"].as<double>();
    station.least = std::numeric_limits<double>::quiet_NaN();
    if (const val place = stations[i]["place"]; !place.isUndefined()) {
      station.least = stations[i]["least"].as<double>();
      station.place = pointAgain(place);
    }
    profile.push_back(station);
  }
  return profile;
}

/// `LimbAxis` of types.ts without its unit, or an error.
val axis(const JobSurface& surface, const val& profile, const val& onProgress) {
  return guarded([&] {
    const auto found = limbAxis(surface.mesh(), stationsOf(profile), reportingTo(onProgress));
    if (!found) return toJs(found.error());
    std::vector<Vec3> middles;
    for (const AxisStation& station : found.value()) middles.push_back(station.centre);
    ResultObject result(surface.drawn());
    result("length", found.value().empty() ? 0 : found.value().back().distance);
    result("loops", found.value());
    result("polyline", drawnPoints(middles, surface.origin()));
    return result.object();
  });
}

EMSCRIPTEN_BINDINGS(girthAxis) { emscripten::function("axis", &axis); }

}  // namespace
}  // namespace girth::bind
