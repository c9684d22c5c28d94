#include "girth/io/write_limbs.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "girth/describe/limbs.h"
#include "text/number_text.h"
#include "write/result_json.h"

namespace girth::io {
namespace {

std::string cell(double value) { return std::isnan(value) ? std::string() : formatNumber(value); }

}  // namespace

std::string limbsJson(const LoadedMesh& loaded, const Limbs& limbs, std::string_view file,
                      double persistence) {
  return ResultJson(file, loaded).addPersistence(persistence).addMembers(limbs).file();
}

std::string limbsCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  std::string text = "limb,length,narrowest,narrowestDistance,median,base,end,apex,unit\n";
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    const Limb& limb = limbs.limbs[i];
    const Index apex = loaded.inputOfVertex[limb.apex];
    text += std::to_string(i) + "," + formatNumber(limb.length) + "," + cell(limb.narrowest) + "," +
            cell(limb.narrowestDistance) + "," + cell(limb.median) + "," + cell(limb.base) + "," +
            std::string(toString(limb.end)) + "," +
            (apex == kNoIndex ? std::string() : std::to_string(apex)) + "," + loaded.unit + "\n";
  }
  return text;
}

std::string limbProfilesCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  std::string text = "limb,distance,ring,median,least,unit\n";
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    for (const GirthStation& station : limbs.limbs[i].profile) {
      text += std::to_string(i) + "," + formatNumber(station.distance) + "," +
              formatNumber(station.ring) + "," + cell(station.median) + "," + cell(station.least) +
              "," + loaded.unit + "\n";
    }
  }
  return text;
}

}  // namespace girth::io
