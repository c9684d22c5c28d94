#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "girth/error.h"
#include "girth/io/save_field.h"
#include "girth/io/save_mesh.h"
#include "surface.h"

namespace py = pybind11;

namespace girth::python {
namespace {

void saveSurface(const Surface& surface, const std::string& path) {
  const auto error = io::saveMesh(path, surface.mesh(), surface.loaded().unit);
  if (error) throwError(*error);
}

/// A field as the Python files of the package hand it over: name, values, unit, method, and the
/// codes of kinds and states, which may be empty.
using GivenField = std::tuple<std::string, Array<double>, std::string, std::string,
                              Array<std::uint8_t>, Array<std::uint8_t>>;

/// Codes of values that are missing count as the last kind: the values are NaN there.
std::vector<LoopKind> kindsOf(const Array<std::uint8_t>& codes) {
  std::vector<LoopKind> kinds;
  for (const std::uint8_t code : spanOf(codes)) {
    kinds.push_back(static_cast<LoopKind>(std::min<std::uint8_t>(code, 2)));
  }
  return kinds;
}

/// NaN where there is none.
std::vector<double> statesOf(const Array<std::uint8_t>& codes) {
  std::vector<double> states;
  for (const std::uint8_t code : spanOf(codes)) {
    states.push_back(code < 3 ? code : std::numeric_limits<double>::quiet_NaN());
  }
  return states;
}

void saveFields(const Surface& surface, const std::string& path,
                const std::vector<GivenField>& given) {
  std::vector<std::vector<LoopKind>> kinds;
  std::vector<std::vector<double>> states;
  kinds.reserve(given.size());
  states.reserve(given.size());
  std::vector<io::VertexField> fields;
  for (const auto& [name, values, unit, method, kindCodes, stateCodes] : given) {
    kinds.push_back(kindsOf(kindCodes));
    fields.push_back({name, spanOf(values), unit, method, kinds.back()});
    if (stateCodes.size() == 0) continue;
    states.push_back(statesOf(stateCodes));
    fields.push_back(io::girthStateField(states.back(), method));
  }
  const auto error = io::saveField(path, surface.loaded(), fields);
  if (error) throwError(*error);
}

}  // namespace

void bindFiles(py::module_& module) {
  module.def("save_mesh", &saveSurface);
  module.def("save_fields", &saveFields);
  module.def("persistent_method", [](double persistence) {
    return io::methodText(GirthOptions{GirthMethod::Exact, persistence});
  });
}

}  // namespace girth::python
