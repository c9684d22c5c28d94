#include "girth/io/write_limbs.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

/// Numbers of tips, from 1.
std::string tipNumbers(const std::vector<Index>& tips) {
  std::string text;
  for (const Index tip : tips) text += (text.empty() ? "" : ",") + std::to_string(tip + 1);
  return "[" + text + "]";
}

std::string stationJson(const LoadedMesh& loaded, const GirthStation& station) {
  return "{\"distance\":" + formatNumber(station.distance) +
         ",\"ring\":" + formatNumber(station.ring) + ",\"median\":" + numberJson(station.median) +
         ",\"least\":" + numberJson(station.least) +
         ",\"place\":" + (std::isnan(station.least) ? "null" : pointJson(loaded, station.place)) +
         "}";
}

std::string limbJson(const LoadedMesh& loaded, const Limb& limb) {
  std::string profile;
  for (const GirthStation& station : limb.profile) {
    profile += (profile.empty() ? "" : ",") + stationJson(loaded, station);
  }
  return "{\"length\":" + formatNumber(limb.length) +
         ",\"narrowest\":" + numberJson(limb.narrowest) +
         ",\"narrowestDistance\":" + numberJson(limb.narrowestDistance) +
         ",\"median\":" + numberJson(limb.median) + ",\"base\":" + numberJson(limb.base) +
         ",\"end\":" + jsonString(toString(limb.end)) + ",\"tips\":" + tipNumbers(limb.tips) +
         ",\"apex\":" + pointJson(loaded, SurfacePoint::atVertex(limb.apex)) +
         ",\"vertices\":" + inputsJson(loaded, limb.vertices) + ",\"profile\":[" + profile + "]}";
}

std::string cell(double value) { return std::isnan(value) ? std::string() : formatNumber(value); }

}  // namespace

std::string limbsJson(const LoadedMesh& loaded, const Limbs& limbs, std::string_view file,
                      double persistence) {
  std::string text = modelJson(file, loaded) + persistenceJson(persistence) + ",\"limbs\":[";
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + limbJson(loaded, limbs.limbs[i]);
  }
  return text + "],\"tipsWithoutLimb\":" + tipNumbers(limbs.tipsWithoutLimb) + "}\n";
}

std::string limbsCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  std::string text = "limb,length,narrowest,narrowestDistance,median,base,end,apex,unit\n";
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    const Limb& limb = limbs.limbs[i];
    const Index apex = loaded.inputOfVertex[limb.apex];
    text += std::to_string(i + 1) + "," + formatNumber(limb.length) + "," + cell(limb.narrowest) +
            "," + cell(limb.narrowestDistance) + "," + cell(limb.median) + "," + cell(limb.base) +
            "," + std::string(toString(limb.end)) + "," +
            (apex == kNoIndex ? std::string() : std::to_string(apex)) + "," + loaded.unit + "\n";
  }
  return text;
}

std::string limbProfilesCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  std::string text = "limb,distance,ring,median,least,unit\n";
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    for (const GirthStation& station : limbs.limbs[i].profile) {
      text += std::to_string(i + 1) + "," + formatNumber(station.distance) + "," +
              formatNumber(station.ring) + "," + cell(station.median) + "," + cell(station.least) +
              "," + loaded.unit + "\n";
    }
  }
  return text;
}

}  // namespace girth::io
