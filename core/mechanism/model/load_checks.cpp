#include "core/mechanism/model/load_checks.h"

#include <set>
#include <unordered_set>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

class LoadCheck {
 public:
  explicit LoadCheck(const Mechanism& mechanism) : m_mechanism(mechanism) {
    if (mechanism.loads.empty() && !mechanism.balances) return;
    for (const Link& link : mechanism.links) m_links.insert(link.id.atom());
    for (const Axis& axis : mechanism.axes) m_axes.insert(axis.id.atom());
    for (const TurningJoint& joint : mechanism.turningJoints) m_joints.insert(joint.id.atom());
  }

  Diagnostics run() {
    checkLosses();
    checkLoads();
    checkBalances();
    return std::move(m_diagnostics);
  }

 private:
  using Known = std::unordered_set<InternedString>;

  void add(Code code, std::string message, std::vector<ElementId> elements, std::string pointer) {
    m_diagnostics.push_back({code, std::move(message), std::move(elements), std::move(pointer), 0, 0});
  }

  void reference(const char* list, const ElementId& to, const Known& known, const std::string& pointer) {
    if (known.contains(to.id)) return;
    add(Code::unknownId,
        translated("%1 names \"%2\", but %3 has no such id.", {list, to.id.text(), listName(to.kind)}), {to},
        pointer);
  }

  void link(const char* list, LinkId link, const std::string& pointer) {
    reference(list, link, m_links, pointer);
    if (m_mechanism.links.empty() || link != m_mechanism.links.front().id) return;
    add(Code::schema,
        translated("The ground takes any load: %1 are on moving links. Name one of those.", {list}), {link},
        pointer);
  }

  void checkLosses() {
    for (std::size_t i = 0; i < m_mechanism.gearMeshes.size(); ++i) {
      const GearMesh& mesh = m_mechanism.gearMeshes[i];
      if (!mesh.efficiency && !mesh.friction) continue;
      if (auto problem = lossProblem(mesh.efficiency, mesh.friction))
        add(Code::schema, std::move(problem->message), {mesh.id},
            "/gearMeshes/" + std::to_string(i) + "/" + problem->member);
    }
    if (!m_mechanism.gearDefaults) return;
    const GearDefaults& defaults = *m_mechanism.gearDefaults;
    if (auto problem = lossProblem(defaults.efficiency, defaults.friction))
      add(Code::schema, std::move(problem->message), {}, std::string("/gearDefaults/") + problem->member);
  }

  void checkLoads() {
    Known ids;
    for (std::size_t i = 0; i < m_mechanism.loads.size(); ++i) {
      const Load& load = m_mechanism.loads[i];
      const std::string at = "/loads/" + std::to_string(i);
      if (!load.id.empty() && !ids.insert(load.id.atom()).second) {
        add(Code::duplicateId, translated("The id \"%1\" occurs twice in %2.", {load.id.text(), "loads"}),
            {load.id}, at + "/id");
      }
      if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) {
        reference("loads", inJoint->joint, m_joints, at + "/joint");
      } else if (const auto* torque = std::get_if<LinkTorque>(&load.action)) {
        link("loads", torque->link, at + "/link");
        if (torque->axis) reference("loads", *torque->axis, m_axes, at + "/axis");
      } else {
        link("loads", std::get<LinkForce>(load.action).link, at + "/link");
      }
    }
  }

  void checkBalances() {
    if (!m_mechanism.balances) return;
    Known joints;
    std::set<std::pair<LinkId, AxisId>> links;
    for (std::size_t i = 0; i < m_mechanism.balances->size(); ++i) {
      const auto& place = (*m_mechanism.balances)[i].at;
      const std::string at = "/balances/" + std::to_string(i);
      if (const auto* joint = std::get_if<JointId>(&place)) {
        reference("balances", *joint, m_joints, at + "/joint");
        if (!joints.insert(joint->atom()).second)
          add(Code::duplicateId,
              translated("The joint \"%1\" occurs twice in %2.", {joint->text(), "balances"}), {*joint},
              at + "/joint");
        continue;
      }
      const auto& onLink = std::get<HoldingTorque::OnLink>(place);
      link("balances", onLink.link, at + "/link");
      if (onLink.axis) reference("balances", *onLink.axis, m_axes, at + "/axis");
      if (!links.insert({onLink.link, onLink.axis.value_or(AxisId())}).second)
        add(Code::duplicateId,
            translated("The link \"%1\" occurs twice in %2.", {onLink.link.text(), "balances"}),
            {onLink.link}, at + "/link");
    }
  }

  const Mechanism& m_mechanism;
  Known m_links;
  Known m_axes;
  Known m_joints;
  Diagnostics m_diagnostics;
};

}  // namespace

Diagnostics loadDiagnostics(const Mechanism& mechanism) {
  return LoadCheck(mechanism).run();
}

std::optional<LossProblem> lossProblem(const std::optional<Number>& efficiency,
                                       const std::optional<Number>& friction) {
  if (efficiency && friction)
    return LossProblem{"friction",
                       translated("A mesh has an efficiency or a coefficient of friction, not both.")};
  if (efficiency && (efficiency->exact().sign() <= 0 || efficiency->exact() > Rational(1)))
    return LossProblem{"efficiency", translated("An efficiency is above 0 and at most 1.")};
  if (friction && (friction->exact().sign() < 0 || friction->exact() > Rational(1)))
    return LossProblem{"friction", translated("A coefficient of friction is from 0 to 1.")};
  return std::nullopt;
}

}  // namespace geargraph
