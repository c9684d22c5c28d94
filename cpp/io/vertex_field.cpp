#include "girth/io/vertex_field.h"

#include <algorithm>
#include <cmath>

namespace girth::io {

bool VertexField::complete() const {
  return std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

std::string_view toString(GirthMethod method) {
  switch (method) {
    case GirthMethod::Exact:
      return "exact";
    case GirthMethod::Naive:
      return "naive";
    case GirthMethod::Marched:
      break;
  }
  return "ms";
}

VertexField girthVertexField(const GirthField& field, GirthMethod method, std::string_view unit) {
  return {"igf", field.values, std::string(unit), std::string(toString(method)), field.kinds};
}

}  // namespace girth::io
