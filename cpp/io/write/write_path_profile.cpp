#include "girth/io/write_path_profile.h"

#include "girth/describe/path_profile.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/point_json.h"

namespace girth::io {

std::string pathProfileCsv(const LoadedMesh& loaded, std::span<const PathStation> stations) {
  std::string text = "distance,girth,x,y,z,kind,unit\n";
  for (const PathStation& station : stations) {
    text += formatNumber(station.distance) + "," + formatNumber(station.girth) + "," +
            pointText(positionOf(loaded.mesh, station.point), ',') + "," +
            std::string(toString(station.kind)) + "," + loaded.unit + "\n";
  }
  return text;
}

std::string pathProfileJson(const LoadedMesh& loaded, std::span<const PathStation> stations,
                            std::string_view file) {
  return ResultJson(file, loaded)
      .addValue("length", stations.empty() ? 0 : stations.back().distance)
      .addValue("stations", stations)
      .file();
}

}  // namespace girth::io
