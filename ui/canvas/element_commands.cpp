#include "ui/canvas/element_commands.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/axis_letters.h"
#include "core/mechanism/model/batch_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/quantity.h"
#include "core/theory/states/state_edits.h"
#include "ui/canvas/brake_edits.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/weld_edits.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

/// A place next to a link's node with room for another one, in sight where there is one; nothing where nodes
/// are placed by the program.
std::optional<CanvasPoint> placeNear(const Mechanism& mechanism, LinkId link, const Extent& sight) {
  constexpr double kDistance = 120;
  constexpr double kRoom = 70;
  constexpr double kInside = 34;  // a disc with its name
  const auto node = mechanism.view.nodes.find(link);
  if (node == mechanism.view.nodes.end()) return std::nullopt;
  const Extent inside = sight.grown(-kInside);
  for (const bool isInSight : {true, false}) {
    if (isInSight && (inside.halfWidth <= 0 || inside.halfHeight <= 0)) continue;
    for (const double distance : {kDistance, 0.75 * kDistance, 1.6 * kDistance, 2.4 * kDistance}) {
      for (const auto& [x, y] : {std::pair(1.0, 0.0),
                                 {0.7, -0.7},
                                 {0.7, 0.7},
                                 {0.0, -1.0},
                                 {0.0, 1.0},
                                 {-0.7, -0.7},
                                 {-0.7, 0.7},
                                 {-1.0, 0.0}}) {
        const CanvasPoint place{node->second.x + x * distance, node->second.y + y * distance};
        const bool free =
            std::none_of(mechanism.view.nodes.begin(), mechanism.view.nodes.end(), [&](const auto& other) {
              return std::hypot(other.second.x - place.x, other.second.y - place.y) < kRoom;
            });
        if (free && (!isInSight || inside.contains(place))) return place;
      }
    }
  }
  return CanvasPoint{node->second.x + kDistance, node->second.y};
}

/// The position of the torque load in the joint or on the link; -1: there is none.
int torqueLoadOf(const Mechanism& mechanism, const ElementId& element) {
  for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
    const auto* inJoint = std::get_if<JointTorque>(&mechanism.loads[i].action);
    const auto* onLink = std::get_if<LinkTorque>(&mechanism.loads[i].action);
    const bool isThere = (inJoint != nullptr && ElementId(inJoint->joint) == element) ||
                         (onLink != nullptr && ElementId(onLink->link) == element);
    if (isThere) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

Number givenTorque(const Mechanism& mechanism, const ElementId& element) {
  const int load = torqueLoadOf(mechanism, element);
  if (load < 0) return {};
  const auto& action = mechanism.loads[static_cast<std::size_t>(load)].action;
  const auto* inJoint = std::get_if<JointTorque>(&action);
  return inJoint != nullptr ? inJoint->torque : std::get<LinkTorque>(action).torque;
}

Expected<Mechanism> withTorque(const Mechanism& before, const ElementId& element, const Number& torque) {
  const int load = torqueLoadOf(before, element);
  decltype(Load::action) action;
  if (element.kind == ElementKind::turningJoint) {
    action = JointTorque{JointId(element.id), torque};
  } else {
    LinkTorque onLink{LinkId(element.id), {}, torque};
    if (load >= 0)
      onLink.axis = std::get<LinkTorque>(before.loads[static_cast<std::size_t>(load)].action).axis;
    action = std::move(onLink);
  }
  if (load >= 0) return withLoadAction(before, load, std::move(action));
  return withLoad(before, Load{{}, std::move(action)});
}

bool ElementCommands::hasTorque(const ElementId& element) const {
  return torqueLoadOf(*m_document.mechanism(), element) >= 0;
}

QString ElementCommands::torqueOf(const ElementId& element) const {
  if (!hasTorque(element)) return {};
  return QString::fromStdString(givenTorque(*m_document.mechanism(), element).text()) + QStringLiteral(" Nm");
}

QString ElementCommands::setTorque(const ElementId& element, const QString& text) {
  const int load = torqueLoadOf(*m_document.mechanism(), element);
  const QString plain = text.trimmed();
  if (plain.isEmpty()) {
    if (load >= 0)
      apply(tr("Remove load"), [load](const Mechanism& before) { return withoutLoad(before, load); });
    return {};
  }
  const auto torque = quantityFromText(plain.toStdString(), Quantity::torque);
  if (!torque) return tr("A torque is a number with its unit: 10 Nm, 500 Nmm, 1/2 kNm");
  apply(load >= 0 ? tr("Set load") : tr("Add load"),
        [element, torque](const Mechanism& before) { return withTorque(before, element, *torque); });
  return {};
}

std::optional<CanvasPoint> ElementCommands::placeBeside(LinkId link) const {
  return placeNear(*m_document.mechanism(), link, m_sight ? m_sight() : Extent{});
}

void ElementCommands::apply(const QString& text, Reduce reduce) {
  m_document.apply({text, std::move(reduce), 0});
}

void ElementCommands::selectAll(bool notes) {
  std::set<ElementId> all;
  const Mechanism& mechanism = *m_document.mechanism();
  for (const Link& link : mechanism.links) all.insert(link.id);
  for (const TurningJoint& joint : mechanism.turningJoints) all.insert(joint.id);
  for (const GearMesh& mesh : mechanism.gearMeshes) all.insert(mesh.id);
  for (const CanvasNote& note : mechanism.view.notes) {
    if (notes) all.insert(note.id);
  }
  m_selection.select(std::move(all));
}

void ElementCommands::removeSelected(bool notes) {
  std::set<ElementId> selected = m_selection.selected();
  if (!notes) std::erase_if(selected, [](const ElementId& each) { return each.kind == ElementKind::note; });
  if (selected.empty()) return;
  std::vector<ElementId> elements(selected.begin(), selected.end());
  if (elements.size() > 1) std::erase(elements, ElementId(m_document.mechanism()->links.front().id));
  apply(tr("Delete %1").arg(describe(*m_document.mechanism(), {elements.begin(), elements.end()})),
        [elements](const Mechanism& mechanism) {
          return withAxisLettersAsBefore(mechanism, withoutElements(mechanism, elements));
        });
}

void ElementCommands::flipSelected() {
  std::vector<ElementId> arrows;
  for (const ElementId& element : m_selection.selected()) {
    const bool arrow = element.kind == ElementKind::turningJoint || element.kind == ElementKind::gearMesh;
    if (arrow) arrows.push_back(element);
  }
  if (arrows.empty()) return;
  apply(tr("Flip %1").arg(describe(*m_document.mechanism(), {arrows.begin(), arrows.end()})),
        [arrows](const Mechanism& mechanism) { return withAllFlipped(mechanism, arrows); });
}

QString ElementCommands::toggleInputs(const std::set<ElementId>& elements) {
  const Mechanism& now = *m_document.mechanism();
  const std::set<JointId> joints = jointsDrivenBy(now, elements);
  if (joints.empty()) {
    QString why;
    for (const ElementId& element : elements) {
      if (element.kind != ElementKind::link) continue;
      why = tr("Cannot be driven: %1").arg(carryingJoint(now, LinkId(element.id)).why);
    }
    return why;
  }
  apply(tr("Drive or release"),
        [joints](const Mechanism& mechanism) { return withInputsToggled(mechanism, joints); });
  return {};
}

void ElementCommands::rename(LinkId link, const QString& name) {
  const std::string text = name.trimmed().toStdString();
  apply(tr("Rename link"),
        [link, text](const Mechanism& mechanism) { return withName(mechanism, link, text); });
}

QString ElementCommands::attachGear(LinkId link) {
  const Mechanism& now = *m_document.mechanism();
  const CarryingJoint carrying = carryingJoint(now, link);
  if (!carrying.joint) return tr("No gear can be attached: %1").arg(carrying.why);
  const TurningJoint& joint = *now.find(*carrying.joint);
  const LinkId carrier = joint.head == link ? joint.tail : joint.head;
  const std::optional<CanvasPoint> at = placeBeside(link);
  apply(tr("Attach gear to %1").arg(describe(now, {link})), [link, carrier, at](const Mechanism& mechanism) {
    return withGearAttached(mechanism, link, carrier, at);
  });
  m_selection.select({m_document.mechanism()->links.back().id});
  return {};
}

void ElementCommands::makeGround(LinkId link) {
  apply(tr("Make ground"), [link](const Mechanism& mechanism) { return withGround(mechanism, link); });
}

QString ElementCommands::weldSelected() {
  const Mechanism& now = *m_document.mechanism();
  const std::set<ElementId> selected = m_selection.selected();
  const QString why = whyNoWeld(now, selected);
  const auto links = linksToWeld(now, selected);
  if (!why.isEmpty() || !links) return why;
  if (m_document.apply(weldEdit(now, links->first, links->second))) m_selection.select({links->first});
  return {};
}

QString ElementCommands::splitSelected() {
  const Mechanism& now = *m_document.mechanism();
  const std::set<ElementId> selected = m_selection.selected();
  const QString why = whyNoSplit(now, selected);
  const std::optional<Split> split = splitOf(now, selected);
  if (!why.isEmpty() || !split) return why;
  if (m_document.apply(splitEdit(now, *split, placeBeside(split->link))))
    m_selection.select({m_document.mechanism()->links.back().id});
  return {};
}

void ElementCommands::pin(const ElementId& element, bool pinned) {
  const QString what = describe(*m_document.mechanism(), {element});
  apply(pinned ? tr("Pin %1").arg(what) : tr("Unpin %1").arg(what),
        [element, pinned](const PlacedMechanism& before) { return withPinned(before, element, pinned); });
}

void ElementCommands::placeAxis(AxisId axis, const AxisChoice& choice) {
  apply(tr("Lay axis %1").arg(QString::fromStdString(axis.text())),
        [axis, choice](const PlacedMechanism& before) { return withAxisChosen(before, axis, choice); });
}

void ElementCommands::setMeshKind(MeshId mesh, MeshKind kind) {
  apply(tr("Change kind"),
        [mesh, kind](const PlacedMechanism& before) { return withKindFitted(before, mesh, kind); });
}

void ElementCommands::flipSide(MeshId mesh, bool ofTail) {
  apply(tr("Move gear to the other side"),
        [mesh, ofTail](const PlacedMechanism& before) { return withBevelSideFlipped(before, mesh, ofTail); });
}

void ElementCommands::addBrake(LinkId link) {
  m_document.apply(brakeEdit(*m_document.mechanism(), link));
}

void ElementCommands::addClutch(LinkId one, LinkId other) {
  m_document.apply(clutchEdit(one, other));
}

void ElementCommands::addFreewheel(LinkId one, LinkId other) {
  m_document.apply(freewheelEdit(one, other));
}

void ElementCommands::engage(ShiftElementId coupling, bool engaged) {
  m_document.apply(engageEdit(*m_document.mechanism(), coupling, engaged));
}

void ElementCommands::toggleBrake(LinkId link) {
  m_document.apply(toggleBrakeEdit(*m_document.mechanism(), link));
}

void ElementCommands::removeCoupling(const ElementId& coupling) {
  apply(tr("Take off %1").arg(describe(*m_document.mechanism(), {coupling})),
        [coupling](const Mechanism& mechanism) -> Expected<Mechanism> {
          Expected<Mechanism> released = withCouplingEngaged(mechanism, ShiftElementId(coupling.id), false);
          if (!released) return released;
          return withoutElements(*std::move(released), std::vector<ElementId>{coupling});
        });
}

}  // namespace geargraph
