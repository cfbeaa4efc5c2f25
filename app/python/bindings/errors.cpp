#include "app/python/bindings/errors.h"

#include <array>

namespace geargraph::python {
namespace {

constexpr std::array<std::string_view, 8> kKinds = {"link",  "axis",     "joint", "mesh",
                                                    "wheel", "coupling", "state", "load"};

[[noreturn]] void raiseError(const char* maker, const py::object& arguments) {
  const py::object error = py::module_::import("geargraph._errors").attr(maker)(*arguments);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  throw py::error_already_set();
}

}  // namespace

std::string_view kindName(ElementKind kind) {
  return kKinds.at(static_cast<std::size_t>(kind));
}

ElementId elementFrom(const std::string& kind, const std::string& id) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds.at(i) == kind) return {static_cast<ElementKind>(i), InternedString(id)};
  }
  throw py::value_error("There is no kind of element \"" + kind + "\".");
}

py::list rowsOf(const Diagnostics& diagnostics) {
  py::list rows;
  for (const Diagnostic& diagnostic : diagnostics) {
    py::list elements;
    for (const ElementId& element : diagnostic.elements)
      elements.append(py::make_tuple(kindName(element.kind), element.id.text()));
    rows.append(
        py::make_tuple(severityName(diagnostic.severity()), codeName(diagnostic.code),
                       diagnostic.detail == Detail::none ? std::string_view() : detailName(diagnostic.detail),
                       diagnostic.message, py::tuple(elements), diagnostic.pointer, diagnostic.line,
                       diagnostic.column, diagnostic.time));
  }
  return rows;
}

void raise(const Diagnostics& diagnostics) {
  raiseError("of_diagnostics", py::make_tuple(rowsOf(diagnostics)));
}

void raise(std::string_view code, const std::string& message) {
  raiseError("of_code", py::make_tuple(code, message));
}

}  // namespace geargraph::python
