#include "girth/io/write_parts.h"

#include "girth/describe/parts.h"
#include "girth/describe/print_check.h"
#include "girth/io/result_json.h"

namespace girth::io {
std::string partsJson(const LoadedMesh& loaded, const Parts& parts, const PartOptions& options,
                      std::string_view file, double persistence) {
  return ResultJson(file, loaded)
      .addPersistence(persistence)
      .addValue("thresholds", options.thresholds)
      .addValue("smoothing", options.smoothing)
      .addValue("parts", parts.parts)
      .file();
}

std::string printCheckJson(const LoadedMesh& loaded, const PrintCheck& check,
                           const PrintLimits& limits, std::string_view file, double persistence) {
  return ResultJson(file, loaded)
      .addPersistence(persistence)
      .addValue("limits", limits)
      .addMembers(check)
      .file();
}

}  // namespace girth::io
