#include "app/python/bindings/document.h"

#include <algorithm>
#include <cmath>

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

namespace {

/// Calls visit(list) with the list of the elements of this kind; raises ValueError for a kind without one.
template <class Visit>
auto withList(const Mechanism& mechanism, const std::string& kind, const Visit& visit) {
  if (kind == "link") return visit(mechanism.links);
  if (kind == "axis") return visit(mechanism.axes);
  if (kind == "joint") return visit(mechanism.turningJoints);
  if (kind == "mesh") return visit(mechanism.gearMeshes);
  if (kind == "coupling") return visit(mechanism.couplings);
  if (kind == "load") return visit(mechanism.loads);
  throw py::value_error("There is no list of \"" + kind + "\".");
}

std::vector<std::string> idsOf(const Document& self, const std::string& kind) {
  return withList(self.mechanism(), kind, [](const auto& list) {
    std::vector<std::string> ids;
    for (const auto& element : list) ids.push_back(element.id.text());
    return ids;
  });
}

/// -1 where there is none.
int positionOf(const Document& self, const std::string& kind, const std::string& id) {
  return withList(self.mechanism(), kind, [&](const auto& list) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const auto& element) { return element.id.text() == id; });
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
  });
}

}  // namespace

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
      .def_property_readonly("name", [](const Document& self) { return self.mechanism().name; })
      .def_property_readonly("notes", [](const Document& self) { return self.mechanism().notes; })
      .def_property_readonly("unit", [](const Document& self) { return self.mechanism().unit; })
      .def("ids", idsOf)
      .def("position", positionOf)
      .def("last",
           [](const Document& self, const std::string& kind) {
             return withList(self.mechanism(), kind, [](const auto& list) {
               return list.empty() ? std::string() : list.back().id.text();
             });
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
                                       geometry->tailPitchRadius(), geometry->headPitchRadius(),
                                       geometry->carrier));
        }
        return meshes;
      });
}

}  // namespace geargraph::python
