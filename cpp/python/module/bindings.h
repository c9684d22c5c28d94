// The parts of the module `girth._girth`. Its functions count vertices and faces as the prepared
// surface does; the Python files of the package turn them into the numbers of the user's arrays.
#pragma once

#include <pybind11/pybind11.h>

namespace girth::python {

/// Failures of the core become exceptions of girth.errors, with code, element, message and hint.
void bindErrors(pybind11::module_& module);
/// Surface: made of arrays or a file; fields, loops, distances, paths, other triangles.
void bindSurface(pybind11::module_& module);
/// Files of surfaces and of fields.
void bindFiles(pybind11::module_& module);
/// Tips, limbs, parts, maxima and print checks.
void bindAnalysis(pybind11::module_& module);
/// Necks, handles and their removal, bottlenecks, profiles and cuts.
void bindLoops(pybind11::module_& module);
/// Fields that shapes are compared by, and the distances between shapes.
void bindComparison(pybind11::module_& module);

}  // namespace girth::python
