#include "ui/canvas/canvas_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/graph/spanning_tree.h"
#include "core/mechanism/edits.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

}  // namespace

Carrying carryingJoint(const Mechanism& mechanism, LinkId link) {
  if (link == mechanism.links.front().id) return {{}, tr("the ground does not move")};
  const Digraph graph(mechanism);
  if (const std::optional<SpanningTree> tree = SpanningTree::of(graph)) {
    const int joint = tree->jointToParent(graph.nodeOf(link));
    return {mechanism.turningJoints[static_cast<std::size_t>(joint)].id, {}};
  }
  std::vector<JointId> into;
  std::vector<JointId> all;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.head == link) into.push_back(joint.id);
    if (joint.head == link || joint.tail == link) all.push_back(joint.id);
  }
  if (into.size() == 1) return {into.front(), {}};
  if (all.size() == 1) return {all.front(), {}};
  return {{}, all.empty() ? tr("no turning joint carries it yet") : tr("several turning joints: click one")};
}

bool isInput(const Mechanism& mechanism, JointId joint) {
  if (!mechanism.inputs) return false;
  return std::any_of(mechanism.inputs->begin(), mechanism.inputs->end(),
                     [&](const Input& input) { return input.joint == joint; });
}

Expected<Mechanism> withInputToggled(const Mechanism& mechanism, JointId joint) {
  std::vector<Input> inputs = mechanism.inputs.value_or(std::vector<Input>{});
  if (isInput(mechanism, joint)) {
    std::erase_if(inputs, [&](const Input& input) { return input.joint == joint; });
  } else {
    inputs.push_back({joint, Number(1), {}});
  }
  if (inputs.empty()) return withInputs(mechanism, std::nullopt);
  return withInputs(mechanism, std::move(inputs));
}

std::set<JointId> jointsDrivenBy(const Mechanism& mechanism, const std::set<ElementId>& elements) {
  std::set<JointId> joints;
  for (const ElementId& element : elements) {
    if (element.kind == ElementKind::turningJoint) joints.insert(JointId(element.id));
    if (element.kind != ElementKind::link) continue;
    const Carrying carrying = carryingJoint(mechanism, LinkId(element.id));
    if (carrying.joint) joints.insert(*carrying.joint);
  }
  return joints;
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
    default:
      return label;
  }
}

}  // namespace geargraph
