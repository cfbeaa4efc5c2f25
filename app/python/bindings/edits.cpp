// Edits: each gives the next document, or raises geargraph.Error and changes nothing.

#include <algorithm>

#include "app/python/bindings/document.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"
#include "core/theory/states/weld_edits.h"

namespace geargraph::python {
namespace {

using OptionalText = std::optional<std::string>;
using ElementNames = std::vector<std::pair<std::string, std::string>>;  ///< kind and id

std::vector<ElementId> elementsFrom(const ElementNames& names) {
  std::vector<ElementId> elements;
  for (const auto& [kind, id] : names) elements.push_back(elementFrom(kind, id));
  return elements;
}

template <class Id>
std::vector<Id> idsFrom(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

std::optional<MeshKind> writtenKind(const OptionalText& name) {
  if (!name) return std::nullopt;
  if (const std::optional<MeshKind> kind = geargraph::meshKindFrom(*name)) return kind;
  throw py::value_error("The kind of a mesh is external, internal, bevel, belt or pins, not \"" + *name +
                        "\".");
}

/// The position of a state by its name; raises geargraph.Error (unknown-id) where there is none.
int stateNamed(const Mechanism& mechanism, const std::string& name) {
  const auto found = std::find_if(mechanism.states.begin(), mechanism.states.end(),
                                  [&](const ShiftState& state) { return state.name == name; });
  if (found == mechanism.states.end()) {
    raise(Diagnostics{{Code::unknownId,
                       "There is no state \"" + name + "\".",
                       {ElementId(ElementKind::state, InternedString(name))},
                       {}}});
  }
  return static_cast<int>(found - mechanism.states.begin());
}

void addPlainEdits(py::class_<Document>& document) {
  document
      .def("with_name",
           [](const Document& self, const std::string& name) {
             Mechanism mechanism = self.mechanism();
             mechanism.name = name;
             return edited(std::move(mechanism));
           })
      .def("with_notes",
           [](const Document& self, const std::string& notes) {
             Mechanism mechanism = self.mechanism();
             mechanism.notes = notes;
             return edited(std::move(mechanism));
           })
      .def("with_unit",
           [](const Document& self, const std::string& unit) {
             Mechanism mechanism = self.mechanism();
             mechanism.unit = unit;
             return edited(std::move(mechanism));
           })
      .def("with_link",
           [](const Document& self, const std::string& name) {
             Mechanism next = valueOrRaise(withLink(self.mechanism(), {}, name));
             next.view.nodes.erase(next.links.back().id);  // drawings lay it out
             return edited(std::move(next));
           })
      .def("with_turning_joint",
           [](const Document& self, const std::string& tail, const std::string& head,
              const std::string& axis) {
             return edited(withTurningJoint(self.mechanism(), LinkId(tail), LinkId(head), AxisId(axis)));
           })
      .def("with_mesh",
           [](const Document& self, const std::string& tail, const std::string& head, int tailTeeth,
              int headTeeth) {
             return edited(withGearMesh(self.mechanism(), LinkId(tail), LinkId(head), tailTeeth, headTeeth));
           })
      .def("with_gear_attached",
           [](const Document& self, const std::string& gear, const std::string& carrier) {
             return edited(withGearAttached(self.mechanism(), LinkId(gear), LinkId(carrier), std::nullopt));
           })
      .def("without",
           [](const Document& self, const ElementNames& elements) {
             return edited(withoutElements(self.mechanism(), elementsFrom(elements)));
           })
      .def("with_flipped",
           [](const Document& self, const std::string& kind, const std::string& id) {
             return edited(withFlipped(self.mechanism(), elementFrom(kind, id)));
           })
      .def("with_renamed",
           [](const Document& self, const std::string& kind, const std::string& id, const std::string& name) {
             return edited(geargraph::withName(self.mechanism(), elementFrom(kind, id), name));
           })
      .def("with_ground",
           [](const Document& self, const std::string& link) {
             return edited(withGround(self.mechanism(), LinkId(link)));
           })
      .def("with_links_merged",
           [](const Document& self, const std::string& link, const std::string& other) {
             return edited(withLinksWelded(self.mechanism(), LinkId(link), LinkId(other)));
           })
      .def("with_link_split",
           [](const Document& self, const std::string& link, const ElementNames& elements) {
             std::vector<ElementId> moving = elementsFrom(elements);
             if (moving.empty()) moving = lastSideOf(self.mechanism(), LinkId(link));
             return edited(withLinkDivided(self.mechanism(), LinkId(link), moving));
           })
      .def("with_inserted", [](const Document& self, const Document& other) {
        return edited(withFragment(self.mechanism(), other.mechanism()));
      });
}

void addGeometryEdits(py::class_<Document>& document) {
  document
      .def("with_axis_placed",
           [](const Document& self, const std::string& axis, const std::optional<TripleText>& point,
              const std::optional<TripleText>& direction) {
             return edited(
                 withAxisPlaced(self.mechanism(), AxisId(axis), tripleFrom(point), tripleFrom(direction)));
           })
      .def("with_joint_axis",
           [](const Document& self, const std::string& joint, const std::string& axis) {
             return edited(withJointAxis(self.mechanism(), JointId(joint), AxisId(axis)));
           })
      .def("with_offset",
           [](const Document& self, const std::string& joint, const NumberText& offset) {
             return edited(withOffset(self.mechanism(), JointId(joint), numberFrom(offset)));
           })
      .def("with_limits",
           [](const Document& self, const std::string& joint, const std::optional<NumberText>& low,
              const std::optional<NumberText>& high) {
             return edited(
                 withJointLimits(self.mechanism(), JointId(joint), {numberFrom(low), numberFrom(high)}));
           })
      .def("with_teeth",
           [](const Document& self, const std::string& mesh, int tail, int head) {
             return edited(withTeeth(self.mechanism(), MeshId(mesh), tail, head));
           })
      .def("with_teeth_fitted",
           [](const Document& self, const std::string& mesh, int tail, int head) {
             return edited(withTeethFitted(self.placed(), MeshId(mesh), tail, head));
           })
      .def("with_mesh_kind",
           [](const Document& self, const std::string& mesh, const OptionalText& kind) {
             return edited(withMeshKind(self.mechanism(), MeshId(mesh), writtenKind(kind)));
           })
      .def("with_pitch_point",
           [](const Document& self, const std::string& mesh, const std::optional<TripleText>& point) {
             return edited(withPitchPoint(self.mechanism(), MeshId(mesh), tripleFrom(point)));
           })
      .def("with_pinned",
           [](const Document& self, const std::string& kind, const std::string& id, bool pinned) {
             return edited(withPinned(self.placed(), elementFrom(kind, id), pinned));
           });
}

void addMotionEdits(py::class_<Document>& document) {
  document
      .def("with_inputs",
           [](const Document& self,
              const std::optional<std::vector<std::pair<std::string, NumberText>>>& speeds) {
             std::optional<std::vector<Input>> inputs;
             if (speeds) {
               inputs.emplace();
               for (const auto& [joint, speed] : *speeds)
                 inputs->push_back({JointId(joint), numberFrom(speed), {}});
             }
             return edited(withInputs(self.mechanism(), std::move(inputs)));
           })
      .def("with_brake",
           [](const Document& self, const std::string& link, const std::string& id) {
             return edited(withBrake(self.mechanism(), LinkId(link), id));
           })
      .def("with_clutch",
           [](const Document& self, const std::string& one, const std::string& other, const std::string& id) {
             return edited(withClutch(self.mechanism(), LinkId(one), LinkId(other), id));
           })
      .def("with_freewheel",
           [](const Document& self, const std::string& first, const std::string& second,
              const std::string& id) {
             return edited(withFreewheel(self.mechanism(), LinkId(first), LinkId(second), id));
           })
      .def("with_state",
           [](const Document& self, const OptionalText& name, const std::vector<std::string>& engaged,
              const OptionalText& drive, const OptionalText& driven) {
             Mechanism next = valueOrRaise(geargraph::withState(self.mechanism()));
             const int state = static_cast<int>(next.states.size()) - 1;
             if (name) next = valueOrRaise(withStateRenamed(std::move(next), state, *name));
             for (const std::string& id : engaged)
               next = valueOrRaise(withEngaged(std::move(next), state, ShiftElementId(id), true));
             if (drive) next = valueOrRaise(withDrive(std::move(next), state, LinkId(*drive)));
             if (driven) next = valueOrRaise(withDriven(std::move(next), state, LinkId(*driven)));
             return edited(std::move(next));
           })
      .def("without_state",
           [](const Document& self, const std::string& name) {
             return edited(withoutState(self.mechanism(), stateNamed(self.mechanism(), name)));
           })
      .def("with_engaged",
           [](const Document& self, const std::vector<std::string>& couplings) {
             return edited(withCouplingsEngaged(self.mechanism(), idsFrom<ShiftElementId>(couplings)));
           })
      .def("with_state_engaged", [](const Document& self, const std::string& name) {
        return edited(withStateEngaged(self.mechanism(), stateNamed(self.mechanism(), name)));
      });
}

HoldingTorque balanceFrom(const std::string& kind, const std::string& id, const OptionalText& axis) {
  HoldingTorque balance;
  if (kind == "joint") {
    balance.at = JointId(id);
  } else {
    balance.at = HoldingTorque::OnLink{LinkId(id), axis ? std::optional(AxisId(*axis)) : std::nullopt};
  }
  return balance;
}

void addLoadEdits(py::class_<Document>& document) {
  document
      .def("with_joint_torque",
           [](const Document& self, const std::string& id, const std::string& joint,
              const NumberText& torque) {
             return edited(
                 withLoad(self.mechanism(), {LoadId(id), JointTorque{JointId(joint), numberFrom(torque)}}));
           })
      .def("with_link_torque",
           [](const Document& self, const std::string& id, const std::string& link, const OptionalText& axis,
              const NumberText& torque) {
             const auto about = axis ? std::optional(AxisId(*axis)) : std::nullopt;
             return edited(withLoad(self.mechanism(),
                                    {LoadId(id), LinkTorque{LinkId(link), about, numberFrom(torque)}}));
           })
      .def("with_force",
           [](const Document& self, const std::string& id, const std::string& link, const TripleText& force,
              const TripleText& point) {
             return edited(withLoad(self.mechanism(), {LoadId(id), LinkForce{LinkId(link), tripleFrom(force),
                                                                             tripleFrom(point)}}));
           })
      .def("with_balances",
           [](const Document& self,
              const std::optional<std::vector<std::tuple<std::string, std::string, OptionalText>>>& places) {
             std::optional<std::vector<HoldingTorque>> balances;
             if (places) {
               balances.emplace();
               for (const auto& [kind, id, axis] : *places) balances->push_back(balanceFrom(kind, id, axis));
             }
             return edited(withBalances(self.mechanism(), std::move(balances)));
           })
      .def("with_sharing",
           [](const Document& self, bool isByStiffness) {
             return edited(withSharing(self.mechanism(),
                                       isByStiffness ? std::optional(LoadSharing::stiffness) : std::nullopt));
           })
      .def("with_drive_torque",
           [](const Document& self, const std::optional<NumberText>& torque) {
             return edited(withDriveTorque(self.mechanism(), numberFrom(torque)));
           })
      .def("with_losses",
           [](const Document& self, const OptionalText& mesh, const std::optional<NumberText>& efficiency,
              const std::optional<NumberText>& friction) {
             if (!mesh)
               return edited(
                   withDefaultLosses(self.mechanism(), numberFrom(efficiency), numberFrom(friction)));
             return edited(withMeshLosses(self.mechanism(), MeshId(*mesh), numberFrom(efficiency),
                                          numberFrom(friction)));
           })
      .def("with_shape",
           [](const Document& self, const std::string& link, const std::string& file,
              const std::optional<TripleText>& position, const std::optional<TripleText>& orientation,
              const std::optional<NumberText>& scale) {
             const Link* const found = self.mechanism().find(LinkId(link));
             std::vector<LinkShape> shapes = found == nullptr ? std::vector<LinkShape>() : found->shapes;
             shapes.push_back({file, tripleFrom(position), tripleFrom(orientation), numberFrom(scale), {}});
             return edited(withShapes(self.mechanism(), LinkId(link), std::move(shapes)));
           });
}

void addMassEdits(py::class_<Document>& document) {
  document
      .def("with_density",
           [](const Document& self, const std::optional<NumberText>& density) {
             return edited(withDensity(self.mechanism(), numberFrom(density)));
           })
      .def("with_gravity",
           [](const Document& self, const std::optional<TripleText>& gravity) {
             return edited(withGravity(self.mechanism(), tripleFrom(gravity)));
           })
      .def("with_mass", [](const Document& self, const std::string& link,
                           const std::optional<NumberText>& mass, const std::optional<TripleText>& center,
                           const std::optional<std::array<std::string, 6>>& inertia) {
        std::optional<LinkMass> stated;
        if (mass) {
          stated = LinkMass{numberFrom(*mass), tripleFrom(center), {}};
          if (inertia) {
            stated->inertia.emplace();
            for (std::size_t i = 0; i < inertia->size(); ++i)
              stated->inertia->at(i) = numberFrom(inertia->at(i));
          }
        }
        return edited(withLinkMass(self.mechanism(), LinkId(link), std::move(stated)));
      });
}

}  // namespace

void addEdits(py::module_& module) {
  auto document = py::class_<Document>(module.attr("Document"));
  addPlainEdits(document);
  addGeometryEdits(document);
  addMotionEdits(document);
  addLoadEdits(document);
  addMassEdits(document);
}

}  // namespace geargraph::python
