#include "text/json_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "text/number_text.h"

namespace girth::io {

std::string jsonString(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string numberJson(double value) {
  return std::isfinite(value) ? formatNumber(value) : std::string("null");
}

}  // namespace girth::io
