#include "girth/fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace girth {
namespace {

constexpr std::array kFields{
#define GIRTH_VERTEX_FIELD(name, unit, module, title, listTitle, meaning, function, method, note) \
  FieldInfo{#name, title, meaning, FieldUnit::unit, false},
#define GIRTH_SPECTRAL_FIELD(name, unit, title, listTitle, meaning, signature, number, count) \
  FieldInfo{#name, title, meaning, FieldUnit::unit, true},
#include "girth/fields.def"
};

/// Functions that cannot fail, and those that can.
template <class Value>
Result<FieldFunction> asField(VertexFunction<Value> function) {
  return FieldFunction(std::move(function));
}
template <class Value>
Result<FieldFunction> asField(Result<VertexFunction<Value>> function) {
  if (!function) return function.error();
  return FieldFunction(std::move(function).value());
}

double numberOf(double value) { return value; }
double numberOf(const GirthValue& girth) { return girth.length; }

}  // namespace

std::span<const FieldInfo> fields() { return kFields; }

const FieldInfo* findField(std::string_view name) {
  const auto* const found = std::find_if(kFields.begin(), kFields.end(),
                                         [&](const FieldInfo& one) { return one.name == name; });
  return found == kFields.end() ? nullptr : found;
}

std::string unitText(FieldUnit unit, std::string_view length) {
  if (unit == FieldUnit::Radian) return "radian";
  if (unit == FieldUnit::Number || length.empty()) return "";
  return std::string(length) + (unit == FieldUnit::PerArea ? "^-2" : "");
}

Result<FieldFunction> fieldFunction(const SurfaceMesh& mesh, std::string_view name,
                                    const FieldOptions& options) {
  if (auto error = checkPersistence(options.persistence)) return *std::move(error);
#define GIRTH_VERTEX_FIELD(field, unit, module, title, listTitle, meaning, function, method, note) \
  if (name == #field) return asField(function);
#include "girth/fields.def"
  return makeError(ErrorCode::Usage, -1, "there is no field '" + std::string(name) + "'");
}

std::string fieldNote(const SurfaceMesh& mesh, std::string_view name, Index withoutValue) {
#define GIRTH_VERTEX_FIELD(field, unit, module, title, listTitle, meaning, function, method, note) \
  if (name == #field) return note;
#include "girth/fields.def"
  return "";
}

Result<FieldValues> fieldValues(const SurfaceMesh& mesh, std::string_view name,
                                const FieldOptions& options, const ExecutionContext& context) {
  const auto function = fieldFunction(mesh, name, options);
  if (!function) return function.error();
  FieldValues result;
  const bool complete = std::visit(
      [&](const auto& one) {
        const auto found = evaluateAll(mesh, one, context);
        for (const auto& value : found.values) result.values.push_back(numberOf(value));
        return found.complete();
      },
      function.value());
  if (!complete) return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished");
  const auto withoutValue = std::count_if(result.values.begin(), result.values.end(),
                                          [](double value) { return std::isnan(value); });
  result.note = fieldNote(mesh, name, static_cast<Index>(withoutValue));
  return result;
}

}  // namespace girth
