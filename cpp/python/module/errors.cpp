#include "girth/error.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <string>

#include "bindings.h"

namespace py = pybind11;

namespace girth::python {
namespace {

/// Sets the exception that stands for an error.
void raise(const Error& error) {
  const py::object exception =
      py::module_::import("pygirth.errors")
          .attr("exception_of")(std::string(toString(error.code)), exitCodeOf(error.code),
                                error.element, error.message, error.hint, error.file);
  PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr());
}

}  // namespace

void bindErrors(py::module_& module) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ThrownError& error) {
      raise(error);
    }
  });
  py::dict codes;
#define GIRTH_ERROR_CODE(name, text, exitCode, hint) codes[text] = py::make_tuple(exitCode, hint);
#include "girth/error_codes.def"
#undef GIRTH_ERROR_CODE
  module.attr("error_codes") = codes;
}

}  // namespace girth::python
