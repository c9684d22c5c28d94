#include "girth/io/write_path_profile.h"

#include "text/json_text.h"
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
  std::string text = modelJson(file, loaded) + ",\"length\":" +
                     formatNumber(stations.empty() ? 0 : stations.back().distance) +
                     ",\"stations\":[";
  const char* separator = "\n";
  for (const PathStation& station : stations) {
    text += separator + ("{\"distance\":" + formatNumber(station.distance)) +
            ",\"girth\":" + formatNumber(station.girth) +
            ",\"kind\":" + jsonString(toString(station.kind)) +
            ",\"point\":" + pointJson(loaded, station.point) + "}";
    separator = ",\n";
  }
  return text + "]}\n";
}

}  // namespace girth::io
