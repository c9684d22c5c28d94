// The axis of a limb or another tube, with the loops along it.

#include <emscripten/bind.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "boundary.h"
#include "described.h"
#include "girth/describe/limb_axis.h"
#include "girth/io/write_limb_axis.h"
#include "job_surface.h"
#include "result_object.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// What the axis needs of `GirthStation[]` of types.ts.
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

/// The loops of `LimbAxis` again.
std::vector<AxisStation> loopsOf(const val& loops) {
  std::vector<AxisStation> stations;
  for (unsigned i = 0; i < loops["length"].as<unsigned>(); ++i) {
    const val loop = loops[i];
    const val centre = loop["centre"];
    AxisStation station;
    station.distance = loop["distance"].as<double>();
    station.along = loop["along"].as<double>();
    station.girth = loop["girth"].as<double>();
    station.centre = {centre[0].as<double>(), centre[1].as<double>(), centre[2].as<double>()};
    station.area = loop["area"].as<double>();
    station.points = curveAgain(loop["points"]);
    stations.push_back(std::move(station));
  }
  return stations;
}

Result<std::string> contentFor(const std::string& format, const io::LoadedMesh& loaded,
                               const std::vector<AxisStation>& axis, const std::string& name) {
  if (format == "csv") return io::limbAxisCsv(loaded, axis);
  if (format == "obj") return io::limbAxisObj(loaded, axis);
  if (format == "glb") return io::limbAxisGlb(loaded, axis);
  if (format == "json") return io::limbAxisJson(loaded, axis, name);
  return makeError(ErrorCode::Usage, -1, "an axis is not written as '" + format + "'");
}

/// {bytes} of a file with the loops of `LimbAxis`, or an error.
val writeAxis(JobSurface& surface, const val& model, const val& loops, const std::string& format) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(model["unit"].as<std::string>());
    return fileOf(contentFor(format, loaded, loopsOf(loops), model["name"].as<std::string>()));
  });
}

EMSCRIPTEN_BINDINGS(girthAxis) {
  emscripten::function("axis", &axis);
  emscripten::function("writeAxis", &writeAxis);
}

}  // namespace
}  // namespace girth::bind
