#include "core/design/synthesis/insertion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

/// Free ids: whole numbers for links, joints and meshes, letters for axes, the set's own names for wheels,
/// couplings and states as long as they are free.
class FreshNames {
 public:
  explicit FreshNames(const Mechanism& mechanism) {
    for (const Link& link : mechanism.links) m_taken.insert(link.id.text());
    for (const TurningJoint& joint : mechanism.turningJoints) m_taken.insert(joint.id.text());
    for (const GearMesh& mesh : mechanism.gearMeshes) m_taken.insert(mesh.id.text());
    for (const Axis& axis : mechanism.axes) m_axes.insert(axis.id.text());
    for (const Wheel& wheel : mechanism.wheels) m_wheels.insert(wheel.id.text());
    for (const ShiftElement& coupling : mechanism.couplings) m_couplings.insert(coupling.id.text());
    for (const ShiftState& state : mechanism.states) m_states.insert(state.name);
  }

  std::string number() {
    while (m_taken.contains(std::to_string(m_next))) ++m_next;
    const std::string text = std::to_string(m_next);
    m_taken.insert(text);
    return text;
  }
  std::string axis() {
    for (int round = 0;; ++round) {
      for (char letter = 'a'; letter <= 'z'; ++letter) {
        std::string id = std::string(1, letter) + (round == 0 ? "" : std::to_string(round));
        if (m_axes.insert(id).second) return id;
      }
    }
  }
  std::string wheel(const std::string& wanted) { return free(wanted, m_wheels); }
  std::string coupling(const std::string& wanted) { return free(wanted, m_couplings); }
  std::string state(const std::string& wanted) { return free(wanted, m_states); }

 private:
  static std::string free(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    for (int i = 2; !taken.insert(name).second; ++i) name = wanted + "." + std::to_string(i);
    return name;
  }

  std::set<std::string> m_taken;
  std::set<std::string> m_axes;
  std::set<std::string> m_wheels;
  std::set<std::string> m_couplings;
  std::set<std::string> m_states;
  int m_next = 1;
};

/// How far along y the set's stated places go, so that its wheels clear what is there.
Rational shiftBeside(const Mechanism& mechanism, const Mechanism& set) {
  if (mechanism.axes.empty()) return 0;
  const auto extent = [](const Mechanism& of, double sign) {
    const Placement placement = placementOf(of);
    double reach = 0;
    for (const AxisLine& line : placement.axes) reach = std::max(reach, sign * line.point[1]);
    for (const auto& mesh : placement.meshes) {
      if (!mesh) continue;
      const double radius = std::max(mesh->tailPitchRadius(), mesh->headPitchRadius());
      reach = std::max(reach, sign * mesh->pitchPoint[1] + 2 * radius);
    }
    return reach;
  };
  constexpr double kGap = 50;
  return Rational::fromDouble(std::ceil(extent(mechanism, 1) + extent(set, -1) + kGap));
}

void shift(std::optional<NumberTriple>& point, const Rational& along) {
  if (point && !along.isZero()) (*point)[1] = Number((*point)[1].exact() + along);
}

/// Copies lists of the set, ids renamed.
class Inserter {
 public:
  Inserter(Mechanism mechanism, const Mechanism& set, CanvasPoint at)
      : m_result(std::move(mechanism)),
        m_set(set),
        m_names(m_result),
        m_at(at),
        m_shift(shiftBeside(m_result, set)) {}

  Mechanism run() {
    const bool wasEmpty = m_result.links.size() == 1;
    addStructure();
    addMeshes();
    addShifting();
    addInputs(wasEmpty);
    if (wasEmpty && m_result.name.empty()) m_result.name = m_set.name;
    return std::move(m_result);
  }

 private:
  void addStructure() {
    const LinkColors colors(m_result);
    m_links[m_set.links.front().id] = m_result.links.front().id;
    const auto nodeOf = [this](LinkId link) {
      const auto found = m_set.view.nodes.find(link);
      return found == m_set.view.nodes.end() ? CanvasPoint{} : found->second;
    };
    for (std::size_t i = 1; i < m_set.links.size(); ++i) {
      Link link = m_set.links[i];
      const CanvasPoint node = nodeOf(link.id);
      const LinkId fresh(m_names.number());
      m_links[link.id] = fresh;
      link.id = fresh;
      m_result.links.push_back(std::move(link));
      m_result.view.nodes[fresh] = {node.x + m_at.x, node.y + m_at.y};
    }
    colors.keepIn(m_result);
    const LinkId ground = m_result.links.front().id;
    if (!m_result.view.nodes.contains(ground)) {
      const CanvasPoint node = nodeOf(m_set.links.front().id);
      m_result.view.nodes[ground] = {node.x + m_at.x, node.y + m_at.y};
    }
    for (Axis axis : m_set.axes) {
      const AxisId fresh(m_names.axis());
      m_axes[axis.id] = fresh;
      axis.id = fresh;
      shift(axis.point, m_shift);
      m_result.axes.push_back(std::move(axis));
    }
    for (TurningJoint joint : m_set.turningJoints) {
      const JointId fresh(m_names.number());
      m_joints[joint.id] = fresh;
      joint.id = fresh;
      joint.tail = m_links.at(joint.tail);
      joint.head = m_links.at(joint.head);
      joint.axis = m_axes.at(joint.axis);
      m_result.turningJoints.push_back(std::move(joint));
    }
  }

  void addMeshes() {
    std::map<WheelId, WheelId> wheels;
    for (Wheel wheel : m_set.wheels) {
      const WheelId fresh(m_names.wheel(wheel.id.text()));
      wheels[wheel.id] = fresh;
      wheel.id = fresh;
      wheel.link = m_links.at(wheel.link);
      m_result.wheels.push_back(std::move(wheel));
    }
    for (GearMesh mesh : m_set.gearMeshes) {
      mesh.id = MeshId(m_names.number());
      mesh.tail = m_links.at(mesh.tail);
      mesh.head = m_links.at(mesh.head);
      if (mesh.tailWheel) mesh.tailWheel = wheels.at(*mesh.tailWheel);
      if (mesh.headWheel) mesh.headWheel = wheels.at(*mesh.headWheel);
      shift(mesh.pitchPoint, m_shift);
      m_result.gearMeshes.push_back(std::move(mesh));
    }
  }

  void addShifting() {
    std::map<ShiftElementId, ShiftElementId> couplings;
    for (ShiftElement coupling : m_set.couplings) {
      const ShiftElementId fresh(m_names.coupling(coupling.id.text()));
      couplings[coupling.id] = fresh;
      coupling.id = fresh;
      for (LinkId& link : coupling.links) link = m_links.at(link);
      m_result.couplings.push_back(std::move(coupling));
    }
    for (const ShiftElementId& id : m_set.engaged) m_result.engaged.push_back(couplings.at(id));
    for (ShiftState state : m_set.states) {
      state.name = m_names.state(state.name);
      for (ShiftElementId& id : state.engaged) id = couplings.at(id);
      if (state.drive) state.drive = m_links.at(*state.drive);
      if (state.driven) state.driven = m_links.at(*state.driven);
      m_result.states.push_back(std::move(state));
    }
  }

  void addInputs(bool wasEmpty) {
    if (!m_set.inputs || (!wasEmpty && !m_result.inputs)) return;
    if (!m_result.inputs) m_result.inputs.emplace();
    for (Input input : *m_set.inputs) {
      input.joint = m_joints.at(input.joint);
      m_result.inputs->push_back(std::move(input));
    }
  }

  Mechanism m_result;
  const Mechanism& m_set;
  FreshNames m_names;
  CanvasPoint m_at;
  Rational m_shift;
  std::map<LinkId, LinkId> m_links;
  std::map<AxisId, AxisId> m_axes;
  std::map<JointId, JointId> m_joints;
};

}  // namespace

Mechanism withInserted(Mechanism mechanism, const Mechanism& set, CanvasPoint at) {
  return Inserter(std::move(mechanism), set, at).run();
}

CanvasPoint freePlace(const Mechanism& mechanism) {
  constexpr double kGap = 150;
  if (mechanism.view.nodes.empty()) return {120, 120};
  CanvasPoint place{-1e300, 1e300};
  for (const auto& [link, point] : mechanism.view.nodes) {
    place.x = std::max(place.x, point.x);
    place.y = std::min(place.y, point.y);
  }
  // The set's ground is the document's, its first column stands one column to the right.
  return {place.x + kGap - 190, place.y};
}

}  // namespace geargraph
