#include <pybind11/pybind11.h>

#include <string>

#include "bindings.h"
#include "girth/version.h"
#include "working.h"

PYBIND11_MODULE(_girth, module) {
  module.doc() = "The core of Girth; use it through the package pygirth.";
  module.attr("version") = std::string(girth::version());
  girth::python::bindErrors(module);
  girth::python::bindSurface(module);
  girth::python::bindFiles(module);
  girth::python::bindAnalysis(module);
  girth::python::bindLoops(module);
  girth::python::bindComparison(module);
  pybind11::module_::import("atexit").attr("register")(
      pybind11::cpp_function(&girth::python::waitForAbandoned));
}
