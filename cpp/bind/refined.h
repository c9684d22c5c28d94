// The refined girth, as both modules that compute it take its options and give it.
#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boundary.h"
#include "girth/describe/refined_girth.h"
#include "result_object.h"

namespace girth::bind {

/// The options of JavaScript (`RefinedRequest` of protocol.ts). INVALID_OPTION for what is no
/// count.
inline Result<RefinedOptions> refinedOptionsOf(const emscripten::val& request) {
  constexpr double kMost = 4e9;
  const auto isCount = [](double number, double most) {
    return number >= 0 && number <= most && number == std::floor(number);
  };
  const auto coarseFaces = request["coarseFaces"].as<double>();
  const auto audit = request["audit"].as<double>();
  const auto seed = request["seed"].as<double>();
  if (!isCount(coarseFaces, kMost) || !isCount(audit, kMost) || !isCount(seed, 1e15)) {
    return makeError(ErrorCode::InvalidOption, -1, "coarseFaces, audit and seed are whole numbers");
  }
  return RefinedOptions{static_cast<Index>(coarseFaces), static_cast<Index>(audit),
                        static_cast<std::uint64_t>(seed)};
}

/// A note on the values for users.
inline std::string refinedNote(const RefinedGirth& refined) {
  const auto missing = std::count_if(refined.field.values.begin(), refined.field.values.end(),
                                     [](double value) { return std::isnan(value); });
  if (missing == 0) return "";
  return std::to_string(missing) + " of " + std::to_string(refined.field.values.size()) +
         " vertices have no value: no loop was found within the bounds of the search";
}

/// `FoundRefined` of protocol.ts, or an error.
inline emscripten::val refinedOf(const SurfaceMesh& mesh, const emscripten::val& request,
                                 const ExecutionContext& context) {
  const Result<RefinedOptions> options = refinedOptionsOf(request);
  if (!options) return toJs(options.error());
  const Result<RefinedGirth> found = refinedGirth(mesh, options.value(), context);
  if (!found) return toJs(found.error());
  const RefinedGirth& refined = found.value();
  // Enumerations of one byte each.
  const auto codes = [](const auto& list) {
    return copyOut<std::uint8_t>("Uint8Array",
                                 {reinterpret_cast<const std::uint8_t*>(list.data()), list.size()});
  };
  static_assert(sizeof(LoopKind) == 1 && sizeof(GirthState) == 1);
  emscripten::val result = emscripten::val::object();
  result.set("values", copyOut<double>("Float64Array", refined.field.values));
  result.set("kinds", codes(refined.field.kinds));
  result.set("states", codes(refined.states));
  result.set("audit", ResultObject().addMembers(refined.audit).object());
  result.set("coarseFaces", refined.coarseFaces);
  result.set("leanFaces", refined.leanFaces);
  result.set("note", refinedNote(refined));
  return result;
}

}  // namespace girth::bind
