#include "girth/io/report_json.h"

#include "girth/describe/prepare_surface.h"
#include "girth/io/result_json.h"

namespace girth::io {

std::string reportJson(const PreparationReport& report) {
  return ResultJson().addMembers(report).text();
}

}  // namespace girth::io
