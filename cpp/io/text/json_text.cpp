#include "girth/io/json_text.h"

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

JsonObject& JsonObject::addJson(std::string_view name, std::string_view value) {
  if (text_.size() > 1 && text_.back() != '\n') text_ += ',';
  ((text_ += '"') += name) += "\":";
  text_ += value;
  return *this;
}

JsonObject& JsonObject::addJsonLine(std::string_view name, std::string_view value) {
  text_ += ",\n";
  return addJson(name, value);
}

}  // namespace girth::io
