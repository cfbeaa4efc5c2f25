#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace geargraph::python {

namespace py = pybind11;

// The parts of the extension module `_geargraph`, one source file per part. Each adds its types and
// functions. They are thin: values are passed as tuples, strings and bytes, which the package `geargraph`
// converts to idiomatic Python.

void addDocument(py::module_& module);
void addEdits(py::module_& module);
void addAnalysis(py::module_& module);
void addSteps(py::module_& module);
void addStatics(py::module_& module);
void addDynamics(py::module_& module);
void addSimulators(py::module_& module);
void addPictures(py::module_& module);
void addExports(py::module_& module);
void addExercises(py::module_& module);
void addSets(py::module_& module);

}  // namespace geargraph::python
