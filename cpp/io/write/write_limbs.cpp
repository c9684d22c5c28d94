#include "girth/io/write_limbs.h"

#include <cstddef>

#include "girth/describe/limbs.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"

namespace girth::io {
std::string limbsJson(const LoadedMesh& loaded, const Limbs& limbs, std::string_view file,
                      double persistence) {
  return ResultJson(file, loaded).addPersistence(persistence).addMembers(limbs).file();
}

std::string limbsCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  ResultCsv<Limb> csv(loaded, "limb");
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    csv.add(limbs.limbs[i], std::to_string(i));
  }
  return csv.text();
}

std::string limbProfilesCsv(const LoadedMesh& loaded, const Limbs& limbs) {
  ResultCsv<GirthStation> csv(loaded, "limb");
  for (std::size_t i = 0; i < limbs.limbs.size(); ++i) {
    for (const GirthStation& station : limbs.limbs[i].profile) {
      csv.add(station, std::to_string(i));
    }
  }
  return csv.text();
}

}  // namespace girth::io
