#include "core/mechanism/model/fragment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/notes.h"

namespace geargraph {
namespace {

constexpr double kStep = 30;   // px that a copy is moved right and down
constexpr double kOnTop = 12;  // px: nodes nearer than this hide each other
constexpr int kMaxFragmentSteps = 200;

/// The links that come along.
std::unordered_set<LinkId> linksOf(const Mechanism& mechanism, const std::set<ElementId>& selected) {
  std::unordered_set<LinkId> links;
  for (const ElementId& element : selected) {
    if (element.kind == ElementKind::link) links.insert(LinkId(element.id));
  }
  const auto addEnds = [&](const auto& arrow) {
    if (!selected.contains(arrow.id)) return;
    links.insert(arrow.tail);
    links.insert(arrow.head);
  };
  std::for_each(mechanism.turningJoints.begin(), mechanism.turningJoints.end(), addEnds);
  std::for_each(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(), addEnds);
  return links;
}

template <class Element, class Keep>
std::vector<Element> kept(const std::vector<Element>& all, const Keep& keep) {
  std::vector<Element> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), keep);
  return some;
}

/// The pasted elements under their new ids.
class Renamer {
 public:
  Renamer(const Mechanism& target, const Mechanism& fragment) {
    m_links.emplace(fragment.links.front().id, target.links.front().id);
    const auto count = fragment.links.size() - 1 + fragment.turningJoints.size() + fragment.gearMeshes.size();
    const std::vector<std::string> ids = freshIds(target, static_cast<int>(count));
    auto next = ids.begin();
    for (std::size_t i = 1; i < fragment.links.size(); ++i) {
      m_links.emplace(fragment.links[i].id, LinkId(*next++));
    }
    for (const TurningJoint& joint : fragment.turningJoints) m_joints.emplace(joint.id, JointId(*next++));
    for (const GearMesh& mesh : fragment.gearMeshes) m_meshes.emplace(mesh.id, MeshId(*next++));
    const auto axes = freshAxisIds(target, static_cast<int>(fragment.axes.size()));
    for (std::size_t i = 0; i < axes.size(); ++i) m_axes.emplace(fragment.axes[i].id, axes[i]);
    nameApart(target.wheels, fragment.wheels, m_wheels);
    nameApart(target.couplings, fragment.couplings, m_couplings);
  }

  [[nodiscard]] LinkId operator()(LinkId id) const { return m_links.at(id); }
  [[nodiscard]] JointId operator()(JointId id) const { return m_joints.at(id); }
  [[nodiscard]] MeshId operator()(MeshId id) const { return m_meshes.at(id); }
  [[nodiscard]] AxisId operator()(AxisId id) const { return m_axes.at(id); }
  [[nodiscard]] WheelId operator()(WheelId id) const { return m_wheels.at(id); }
  [[nodiscard]] ShiftElementId operator()(ShiftElementId id) const { return m_couplings.at(id); }

 private:
  /// Ids of one's own keep their word: "brake" becomes "brake-2".
  template <class Element, class IdType>
  static void nameApart(const std::vector<Element>& there, const std::vector<Element>& coming,
                        std::unordered_map<IdType, IdType>& names) {
    std::unordered_set<std::string> taken;
    for (const Element& element : there) taken.insert(element.id.text());
    for (const Element& element : coming) {
      std::string name = element.id.text();
      for (int number = 2; taken.contains(name); ++number) {
        name = element.id.text() + "-" + std::to_string(number);
      }
      taken.insert(name);
      names.emplace(element.id, IdType(name));
    }
  }

  std::unordered_map<LinkId, LinkId> m_links;
  std::unordered_map<JointId, JointId> m_joints;
  std::unordered_map<MeshId, MeshId> m_meshes;
  std::unordered_map<AxisId, AxisId> m_axes;
  std::unordered_map<WheelId, WheelId> m_wheels;
  std::unordered_map<ShiftElementId, ShiftElementId> m_couplings;
};

/// How far the pasted nodes and notes have to go so that none lies on one that is there.
double shiftFor(const View& there, const Mechanism& fragment) {
  std::set<std::pair<long, long>> taken;
  const auto cell = [](double x, double y) {
    return std::pair(std::lround(x / kOnTop), std::lround(y / kOnTop));
  };
  for (const auto& [link, point] : there.nodes) taken.insert(cell(point.x, point.y));
  for (const CanvasNote& note : there.notes) taken.insert(cell(note.at.x, note.at.y));
  const LinkId ground = fragment.links.front().id;
  for (int step = 0; step < kMaxFragmentSteps; ++step) {
    const double shift = step * kStep;
    const auto isTaken = [&](CanvasPoint at) { return taken.contains(cell(at.x + shift, at.y + shift)); };
    const bool hides =
        std::any_of(fragment.view.nodes.begin(), fragment.view.nodes.end(),
                    [&](const auto& node) { return node.first != ground && isTaken(node.second); }) ||
        std::any_of(fragment.view.notes.begin(), fragment.view.notes.end(),
                    [&](const CanvasNote& note) { return isTaken(note.at); });
    if (!hides) return shift;
  }
  return kMaxFragmentSteps * kStep;
}

/// Puts the new ids into what an element refers to.
template <class Tag>
void renameReference(Id<Tag>& id, const Renamer& renamed) {
  if constexpr (requires { renamed(id); }) id = renamed(id);
}
template <class Value>
void renameReference(Value& /*no id*/, const Renamer& /*renamed*/) {}
template <class Value>
void renameReference(std::optional<Value>& value, const Renamer& renamed) {
  if (value) renameReference(*value, renamed);
}
template <class Tag>
void renameReference(std::vector<Id<Tag>>& ids, const Renamer& renamed) {
  for (Id<Tag>& id : ids) renameReference(id, renamed);
}
void renameReference(decltype(Load::action)& action, const Renamer& renamed) {
  if (auto* inJoint = std::get_if<JointTorque>(&action)) {
    inJoint->joint = renamed(inJoint->joint);
  } else if (auto* torque = std::get_if<LinkTorque>(&action)) {
    torque->link = renamed(torque->link);
    renameReference(torque->axis, renamed);
  } else {
    renameReference(std::get<LinkForce>(action).link, renamed);
  }
}

/// The element under its new id, if elements of its kind get one, with those of what it refers to.
template <class Element>
Element renamedElement(Element element, const Renamer& renamed) {
  forEachField<Element>([&](const auto& field) { renameReference(element.*field.member, renamed); });
  return element;
}

template <class Element>
void addRenamed(std::vector<Element>& into, const std::vector<Element>& from, const Renamer& renamed) {
  for (const Element& element : from) into.push_back(renamedElement(element, renamed));
}

void addArrows(Mechanism& mechanism, const Mechanism& fragment, const Renamer& renamed) {
  addRenamed(mechanism.axes, fragment.axes, renamed);
  addRenamed(mechanism.turningJoints, fragment.turningJoints, renamed);
  addRenamed(mechanism.wheels, fragment.wheels, renamed);
  addRenamed(mechanism.gearMeshes, fragment.gearMeshes, renamed);
  addRenamed(mechanism.couplings, fragment.couplings, renamed);
}

/// The loads whose joint or link is pasted, under the pasted ids; their own ids stay where they are free.
void addLoads(Mechanism& mechanism, const Mechanism& fragment, const Renamer& renamed) {
  std::unordered_set<InternedString> taken;
  for (const Load& load : mechanism.loads) taken.insert(load.id.atom());
  for (const Load& original : fragment.loads) {
    Load load = renamedElement(original, renamed);
    const bool isFree = load.id.empty() || !taken.contains(load.id.atom());
    if (!isFree) load.id = LoadId();
    mechanism.loads.push_back(std::move(load));
  }
}

/// Do the joint, the link and the axis that the load names come along?
bool comesAlong(const Load& load, const std::unordered_set<LinkId>& links,
                const std::unordered_set<AxisId>& axes, const std::unordered_set<JointId>& joints) {
  if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) return joints.contains(inJoint->joint);
  const auto* torque = std::get_if<LinkTorque>(&load.action);
  if (torque != nullptr && torque->axis && !axes.contains(*torque->axis)) return false;
  return links.contains(*linkOf(load));
}

void addNotes(std::vector<CanvasNote>& into, const std::vector<CanvasNote>& from,
              const std::vector<NoteId>& ids, double shift) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    CanvasNote note = from[i];
    note.id = ids[i];
    note.at = {note.at.x + shift, note.at.y + shift};
    into.push_back(std::move(note));
  }
}

}  // namespace

Mechanism fragmentOf(const Mechanism& mechanism, const std::set<ElementId>& selected) {
  const std::unordered_set<LinkId> links = linksOf(mechanism, selected);
  const auto has = [&](LinkId link) { return links.contains(link); };
  const auto among = [&](const auto& arrow) { return has(arrow.tail) && has(arrow.head); };
  Mechanism fragment;
  fragment.unit = mechanism.unit;
  fragment.links.push_back(mechanism.links.front());
  for (std::size_t i = 1; i < mechanism.links.size(); ++i) {
    if (has(mechanism.links[i].id)) fragment.links.push_back(mechanism.links[i]);
  }
  fragment.turningJoints = kept(mechanism.turningJoints, among);
  fragment.gearMeshes = kept(mechanism.gearMeshes, among);
  std::unordered_set<AxisId> axes;
  std::unordered_set<JointId> joints;
  for (const TurningJoint& joint : fragment.turningJoints) {
    axes.insert(joint.axis);
    joints.insert(joint.id);
  }
  fragment.axes = kept(mechanism.axes, [&](const Axis& axis) { return axes.contains(axis.id); });
  fragment.wheels = kept(mechanism.wheels, [&](const Wheel& wheel) { return has(wheel.link); });
  fragment.couplings = kept(mechanism.couplings, [&](const ShiftElement& coupling) {
    return std::all_of(coupling.links.begin(), coupling.links.end(), has);
  });
  if (mechanism.inputs) {
    fragment.inputs =
        kept(*mechanism.inputs, [&](const Input& input) { return joints.contains(input.joint); });
    if (fragment.inputs->empty()) fragment.inputs.reset();
  }
  fragment.loads =
      kept(mechanism.loads, [&](const Load& load) { return comesAlong(load, links, axes, joints); });
  for (const auto& [link, point] : mechanism.view.nodes) {
    if (has(link)) fragment.view.nodes.emplace(link, point);
  }
  fragment.view.notes =
      kept(mechanism.view.notes, [&](const CanvasNote& note) { return selected.contains(note.id); });
  return fragment;
}

bool isEmptyFragment(const Mechanism& fragment) {
  return fragment.links.size() == 1 && fragment.view.notes.empty();
}

Expected<Mechanism> withFragment(Mechanism mechanism, const Mechanism& fragment) {
  if (isEmptyFragment(fragment)) {
    return Diagnostic{Code::schema, translated("There is no link or note in what was copied."), {}, {}, 0, 0};
  }
  const Renamer renamed(mechanism, fragment);
  const double shift = shiftFor(mechanism.view, fragment);
  const LinkColors colors(mechanism);
  for (std::size_t i = 1; i < fragment.links.size(); ++i) {
    Link link = renamedElement(fragment.links[i], renamed);
    const auto node = fragment.view.nodes.find(fragment.links[i].id);
    if (node != fragment.view.nodes.end()) {
      mechanism.view.nodes[link.id] = {node->second.x + shift, node->second.y + shift};
    }
    mechanism.links.push_back(std::move(link));
  }
  colors.keepIn(mechanism);
  addArrows(mechanism, fragment, renamed);
  addLoads(mechanism, fragment, renamed);
  addNotes(mechanism.view.notes, fragment.view.notes, freshNoteIds(mechanism, fragment.view.notes.size()),
           shift);
  if (fragment.inputs) {
    if (!mechanism.inputs) mechanism.inputs.emplace();
    addRenamed(*mechanism.inputs, *fragment.inputs, renamed);
  }
  return mechanism;
}

std::set<ElementId> elementsAdded(const Mechanism& before, const Mechanism& after) {
  std::unordered_set<ElementId> known;
  const auto each = [](const Mechanism& mechanism, const auto& use) {
    for (const Link& link : mechanism.links) use(ElementId(link.id));
    for (const TurningJoint& joint : mechanism.turningJoints) use(ElementId(joint.id));
    for (const GearMesh& mesh : mechanism.gearMeshes) use(ElementId(mesh.id));
    for (const CanvasNote& note : mechanism.view.notes) use(ElementId(note.id));
  };
  each(before, [&](const ElementId& element) { known.insert(element); });
  std::set<ElementId> added;
  each(after, [&](const ElementId& element) {
    if (!known.contains(element)) added.insert(element);
  });
  return added;
}

}  // namespace geargraph
