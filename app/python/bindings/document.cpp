#include "app/python/bindings/document.h"

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/validate.h"

namespace geargraph::python {

Number numberFrom(const NumberText& text) {
  const auto number = Number::fromText(text);
  if (!number)
    raise(Diagnostics{{Code::schema, "\"" + text + "\" is no number: 3, 0.25 and 22/7 are.", {}, {}}});
  return *number;
}

std::optional<Number> numberFrom(const std::optional<NumberText>& text) {
  return text ? std::optional(numberFrom(*text)) : std::nullopt;
}

NumberTriple tripleFrom(const TripleText& text) {
  return {numberFrom(text[0]), numberFrom(text[1]), numberFrom(text[2])};
}

std::optional<NumberTriple> tripleFrom(const std::optional<TripleText>& text) {
  return text ? std::optional(tripleFrom(*text)) : std::nullopt;
}

Rational rationalFrom(const NumberText& text) {
  return numberFrom(text).exact();
}

Document edited(Expected<Mechanism> result) {
  return edited(unplaced(std::move(result)));
}

Document edited(Expected<PlacedMechanism> result) {
  PlacedMechanism placed = valueOrRaise(std::move(result));
  const Diagnostics wrong = wellFormedDiagnostics(placed);
  if (!wrong.empty()) raise(wrong);
  return Document(std::move(placed));
}

void addDocument(py::module_& module) {
  py::class_<Document>(module, "Document")
      .def_static("empty", [] { return Document(emptyMechanism()); })
      .def_static("read",
                  [](const py::bytes& bytes) {
                    const std::string_view text = bytes;
                    auto read = [&] {
                      const py::gil_scoped_release unlocked;
                      return readMechanism(text);
                    }();
                    return Document(valueOrRaise(std::move(read)));
                  })
      .def("write", [](const Document& self) { return writeMechanism(self.mechanism()); })
      .def("__eq__",
           [](const Document& self, const Document& other) { return self.mechanism() == other.mechanism(); })
      .def_property_readonly("counts",
                             [](const Document& self) {
                               const Mechanism& m = self.mechanism();
                               return py::make_tuple(m.n(), m.t(), m.c());
                             })
      .def("axes",
           [](const Document& self) {
             py::list axes;
             for (std::size_t i = 0; i < self.mechanism().axes.size(); ++i) {
               const AxisLine& line = self.placed().placement().axes[i];
               axes.append(py::make_tuple(self.mechanism().axes[i].id.text(), line.point, line.direction,
                                          line.automatic));
             }
             return axes;
           })
      .def("meshes", [](const Document& self) {
        // By mesh: kind, pitch point, radii of tail and head, carrier's position; None without a geometry.
        py::list meshes;
        for (const auto& geometry : self.placed().placement().meshes) {
          if (!geometry) {
            meshes.append(py::none());
            continue;
          }
          meshes.append(py::make_tuple(meshKindName(geometry->kind), geometry->pitchPoint,
                                       std::abs(geometry->tailRadius), std::abs(geometry->headRadius),
                                       geometry->carrier));
        }
        return meshes;
      });
}

}  // namespace geargraph::python
