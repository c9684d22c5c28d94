#include "girth/io/vertex_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "text/number_text.h"

namespace girth::io {
namespace {

bool isName(std::string_view text) {
  const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
  return !text.empty() && isSmall(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) {
           return isSmall(c) || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
         });
}

}  // namespace

bool VertexField::complete() const {
  return std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

std::string_view toString(GirthMethod method) {
  switch (method) {
    case GirthMethod::Exact:
      return "exact";
    case GirthMethod::Marched:
      break;
  }
  return "ms";
}

std::string methodText(const GirthOptions& options) {
  const std::string method(toString(options.method));
  return options.persistence == 0 ? method
                                  : method + ", persistence " + formatNumber(options.persistence);
}

std::string_view toString(DistanceMethod method) {
  return method == DistanceMethod::Exact ? "exact" : "fast marching";
}

std::string methodText(const ShapeDiameterOptions& options) {
  return std::to_string(options.rays) + (options.rays == 1 ? " ray" : " rays");
}

std::string methodText(const ThicknessOptions& options) {
  // Radians cannot hold most degrees exactly.
  const double degrees = std::round(1e6 * options.sharpRadians * 180 / std::numbers::pi) / 1e6;
  return "sharp below " + formatNumber(degrees) + " degrees";
}

std::string methodText(std::string_view field, const FieldOptions& options) {
#define GIRTH_VERTEX_FIELD(name, unit, module, title, listTitle, meaning, function, method, note) \
  if (field == #name) return method;
#include "girth/fields.def"
  return "";
}

std::optional<Error> checkFields(const LoadedMesh& loaded, std::span<const VertexField> fields) {
  const auto fault = [](const std::string& message) {
    return makeError(ErrorCode::Usage, -1, message);
  };
  if (fields.empty()) return fault("there is no field to write");
  const std::size_t vertices = loaded.mesh.vertexCount();
  // Columns that files have already.
  std::set<std::string_view> names{"vertex", "kind", "x", "y", "z"};
  bool hasKinds = false;
  for (const VertexField& field : fields) {
    if (!isName(field.name)) {
      return fault("'" + field.name +
                   "' is not a name of a small letter, then letters, digits and underscores");
    }
    if (!names.insert(field.name).second) {
      return fault("the name '" + field.name + "' is taken by another column");
    }
    if (field.values.size() != vertices ||
        (!field.kinds.empty() && field.kinds.size() != vertices)) {
      return fault("'" + field.name + "' has " + std::to_string(field.values.size()) +
                   " values and " + std::to_string(field.kinds.size()) + " kinds for " +
                   std::to_string(vertices) + " vertices");
    }
    if (hasKinds && !field.kinds.empty()) return fault("several fields have kinds");
    hasKinds = hasKinds || !field.kinds.empty();
    if (!field.kinds.empty() && field.kindName != "kind" && !names.insert(field.kindName).second) {
      return fault("the name '" + field.kindName + "' is taken by another column");
    }
  }
  return std::nullopt;
}

VertexField girthVertexField(const GirthField& field, GirthMethod method, std::string_view unit) {
  return {"igf", field.values, std::string(unit), std::string(toString(method)), field.kinds};
}

VertexField girthStateField(std::span<const double> codes, std::string_view method) {
  static const std::array words{toString(GirthState::Proved), toString(GirthState::Consistent),
                                toString(GirthState::Suspect)};
  return {"state", codes, "", std::string(method), {}, "kind", words};
}

}  // namespace girth::io
