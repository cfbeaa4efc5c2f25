#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/foundations/base/ordinal.h"

namespace pybind11::detail {

/// An int in Python.
template <class Tag>
struct type_caster<geargraph::Ordinal<Tag>> {
  PYBIND11_TYPE_CASTER(geargraph::Ordinal<Tag>, const_name("int"));

  bool load(handle source, bool convert) {
    make_caster<int> position;
    if (!position.load(source, convert)) return false;
    value = cast_op<int>(position);
    return true;
  }
  static handle cast(geargraph::Ordinal<Tag> ordinal, return_value_policy, handle) {
    return PyLong_FromLong(ordinal);
  }
};

/// A list in Python.
template <class Tag, class T>
struct type_caster<geargraph::OrdinalVector<Tag, T>> : list_caster<geargraph::OrdinalVector<Tag, T>, T> {};

}  // namespace pybind11::detail

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
void addExporters(py::module_& module);
void addExercises(py::module_& module);
void addSets(py::module_& module);
void addTeeth(py::module_& module);
void addDesign(py::module_& module);

}  // namespace geargraph::python
