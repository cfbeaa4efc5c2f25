#include "ui/canvas/canvas_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

CarryingJoint carryingJoint(const Mechanism& mechanism, const Digraph& graph,
                            const std::optional<SpanningTree>& tree, LinkId link) {
  if (link == mechanism.links.front().id) return {{}, tr("the ground does not move")};
  const int node = graph.nodeOf(link);
  if (tree) {
    const int joint = tree->jointToParent(node);
    return {mechanism.turningJoints[static_cast<std::size_t>(joint)].id, {}};
  }
  std::vector<JointId> into;
  std::vector<JointId> all;
  for (const int joint : graph.turningEdgesAt(node)) {
    const JointId id = mechanism.turningJoints[static_cast<std::size_t>(joint)].id;
    if (!all.empty() && all.back() == id) continue;  // from the link to itself
    if (graph.turningEdge(joint).head == node) into.push_back(id);
    all.push_back(id);
  }
  if (into.size() == 1) return {into.front(), {}};
  if (all.size() == 1) return {all.front(), {}};
  return {{}, all.empty() ? tr("no turning joint carries it yet") : tr("several turning joints: click one")};
}

}  // namespace

CarryingJoint carryingJoint(const Mechanism& mechanism, LinkId link) {
  const Digraph graph(mechanism);
  return carryingJoint(mechanism, graph, SpanningTree::of(graph), link);
}

bool isInput(const Mechanism& mechanism, JointId joint) {
  if (!mechanism.inputs) return false;
  return std::any_of(mechanism.inputs->begin(), mechanism.inputs->end(),
                     [&](const Input& input) { return input.joint == joint; });
}

Expected<Mechanism> withInputToggled(const Mechanism& mechanism, JointId joint) {
  return withInputsToggled(mechanism, {joint});
}

Expected<Mechanism> withInputsToggled(const Mechanism& mechanism, const std::set<JointId>& joints) {
  std::vector<Input> inputs = mechanism.inputs.value_or(std::vector<Input>{});
  std::set<JointId> added = joints;
  std::erase_if(inputs, [&](const Input& input) { return added.erase(input.joint) > 0; });
  for (const JointId joint : added) inputs.push_back({joint, Number(1), {}});
  if (inputs.empty()) return withInputs(mechanism, std::nullopt);
  return withInputs(mechanism, std::move(inputs));
}

std::set<JointId> jointsDrivenBy(const Mechanism& mechanism, const std::set<ElementId>& elements) {
  std::set<JointId> joints;
  const Digraph graph(mechanism);
  const std::optional<SpanningTree> tree = SpanningTree::of(graph);
  for (const ElementId& element : elements) {
    if (element.kind == ElementKind::turningJoint) joints.insert(JointId(element.id));
    if (element.kind != ElementKind::link) continue;
    const CarryingJoint carrying = carryingJoint(mechanism, graph, tree, LinkId(element.id));
    if (carrying.joint) joints.insert(*carrying.joint);
  }
  return joints;
}

std::optional<MeshKind> shownKind(const PlacedMechanism& placed, MeshId mesh) {
  const Mechanism& mechanism = placed.mechanism();
  const GearMesh* found = mechanism.find(mesh);
  if (found == nullptr || found->kind) return found == nullptr ? std::nullopt : found->kind;
  const auto& geometry =
      placed.placement().meshes[static_cast<std::size_t>(found - mechanism.gearMeshes.data())];
  return geometry ? std::optional(geometry->kind) : std::nullopt;
}

QString describe(const Mechanism& mechanism, const std::set<ElementId>& elements) {
  if (elements.size() != 1) return tr("%1 elements").arg(elements.size());
  const ElementId& element = *elements.begin();
  const QString label = QString::fromStdString(labelOf(mechanism, element).value_or(element.id.text()));
  switch (element.kind) {
    case ElementKind::link:
      return tr("link %1").arg(label);
    case ElementKind::turningJoint:
      return tr("turning joint %1").arg(label);
    case ElementKind::gearMesh:
      return tr("gear mesh %1").arg(label);
    case ElementKind::axis:
      return tr("axis %1").arg(label);
    case ElementKind::coupling: {
      const ShiftElement* coupling = mechanism.find(ShiftElementId(element.id));
      return QString::fromStdString(
          couplingName(coupling == nullptr ? ShiftElementKind::clutch : coupling->kind, label.toStdString()));
    }
    case ElementKind::note:
      return tr("note");
    default:
      return label;
  }
}

QString describeFully(const Mechanism& mechanism, const ElementId& element) {
  QString text = describe(mechanism, {element});
  text[0] = text[0].toUpper();
  if (element.kind == ElementKind::link) {
    const Link* link = mechanism.find(LinkId(element.id));
    if (link != nullptr && !link->name.empty()) text += ": " + QString::fromStdString(link->name);
    return text;
  }
  if (element.kind == ElementKind::note) {
    const CanvasNote* note = mechanism.find(NoteId(element.id));
    return note == nullptr ? text : text + ": " + QString::fromStdString(note->text);
  }
  const auto ends = [&](LinkId tail, LinkId head) {
    return tr(" from link %1 to link %2")
        .arg(QString::fromStdString(*labelOf(mechanism, tail)),
             QString::fromStdString(*labelOf(mechanism, head)));
  };
  if (const ShiftElement* coupling = mechanism.find(ShiftElementId(element.id));
      coupling != nullptr && element == ElementId(coupling->id)) {
    QStringList links;
    for (const LinkId link : coupling->links) links << QString::fromStdString(*labelOf(mechanism, link));
    return text + (coupling->kind == ShiftElementKind::brake
                       ? tr(": holds link %1 while it is engaged").arg(links.join(QString()))
                       : tr(": links %1 turn as one while it is engaged").arg(links.join(tr(" and "))));
  }
  if (const TurningJoint* joint = mechanism.find(JointId(element.id));
      joint != nullptr && element == ElementId(joint->id)) {
    text += ends(joint->tail, joint->head) + tr(", axis %1").arg(QString::fromStdString(joint->axis.text()));
    if (isInput(mechanism, joint->id)) text += tr(", driven");
  }
  if (const GearMesh* mesh = mechanism.find(MeshId(element.id));
      mesh != nullptr && element == ElementId(mesh->id)) {
    text += ends(mesh->tail, mesh->head) + tr(", %1 : %2 teeth").arg(mesh->tailTeeth).arg(mesh->headTeeth);
  }
  return text;
}

}  // namespace geargraph
