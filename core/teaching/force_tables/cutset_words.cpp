#include "core/teaching/force_tables/cutset_words.h"

#include <algorithm>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxCutsetNames = 12;

/// The equation of a sum that is determined, or not.
std::string equationOf(const std::string& symbols, const std::string& numbers, bool isDetermined) {
  if (isDetermined) return symbols + " = 0: " + numbers + " = 0 N m";
  return translated("%1 = 0, shared in unknown parts", {symbols});
}

/// Which links a joint cuts off, and which meshes cross.
std::string sentenceOf(const std::string& joint, const std::vector<std::string>& links,
                       const std::vector<std::string>& meshes) {
  const std::string beyond = listed(links, kMaxCutsetNames);
  const std::string crossing = listed(meshes, kMaxCutsetNames);
  if (links.size() == 1) {
    if (meshes.empty()) return translated("Joint %1 cuts off link %2: no mesh crosses.", {joint, beyond});
    if (meshes.size() == 1)
      return translated("Joint %1 cuts off link %2: mesh %3 crosses.", {joint, beyond, crossing});
    return translated("Joint %1 cuts off link %2: meshes %3 cross.", {joint, beyond, crossing});
  }
  if (meshes.empty()) return translated("Joint %1 cuts off links %2: no mesh crosses.", {joint, beyond});
  if (meshes.size() == 1)
    return translated("Joint %1 cuts off links %2: mesh %3 crosses.", {joint, beyond, crossing});
  return translated("Joint %1 cuts off links %2: meshes %3 cross.", {joint, beyond, crossing});
}

class Cutset {
 public:
  Cutset(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
         const StaticsReport& report, JointOrdinal joint)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_report(report),
        m_joint(joint),
        m_isBeyond(static_cast<std::size_t>(model.n()) + 1, 0) {
    const SpanningTree& tree = model.tree();
    const LinkOrdinal child = tree.child(joint);
    for (const LinkOrdinal link : tree.preorder())
      if (link == child || (link != 0 && isBeyond(tree.parent(link)))) m_isBeyond[link] = 1;
    // The joint's torque is that of its tail on its head.
    m_sense = model.graph().turningEdge(joint).head == child ? 1 : -1;
  }

  CutsetWords words() {
    m_words.joint = m_mechanism.turningJoints[m_joint].id;
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link)
      if (isBeyond(link)) m_words.beyond.emplace_back(m_mechanism.links[link].id);
    addOwn();
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) addMesh(mesh);
    addHeldParts();
    addLoads();
    describe();
    return std::move(m_words);
  }

 private:
  [[nodiscard]] bool isBeyond(LinkOrdinal link) const { return m_isBeyond[link] != 0; }

  void add(ElementId element, std::string symbol, Real torque, bool isDetermined = true) {
    m_words.terms.push_back({std::move(element), std::move(symbol), std::move(torque), isDetermined});
  }

  /// What acts in the joint: loads and the balance that is found there.
  void addOwn() {
    Real torque;
    bool isDetermined = true;
    for (const AppliedTorque& load : m_report.problem.torques)
      if (load.place.joint == m_joint) torque += Real(load.torque);
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int balance = m_report.held[part].balance;
      if (balance < 0 || m_report.problem.balances[static_cast<std::size_t>(balance)].joint != m_joint)
        continue;
      torque += m_report.solution().values[static_cast<std::size_t>(m_model.c()) + part];
      isDetermined = m_report.solution().isDetermined(m_model.c() + static_cast<int>(part));
    }
    add(m_words.joint, "T" + std::to_string(m_mechanism.jointLabel(m_joint)), torque, isDetermined);
  }

  /// A mesh is a port on each gear and the reactions of both on the carrier: it crosses where the joint lies
  /// between a gear and the carrier, on the gear's own axis.
  void addMesh(MeshOrdinal mesh) {
    const MeshGeometry& geometry = *m_placement.meshes[mesh];
    const PortTorques ports = portTorques(m_model, m_report.solution(), m_report.losses(), mesh);
    Real torque;
    bool crosses = false;
    const auto addPort = [&](int gear, const Real& port) {
      if (isBeyond(gear) == isBeyond(geometry.carrier)) return;
      const int side = isBeyond(gear) ? m_sense : -m_sense;
      torque += Real(side * m_placement.classes->orientationSign[m_joint]) * port;
      crosses = true;
    };
    addPort(geometry.tail, ports.tail);
    addPort(geometry.head, ports.head);
    if (crosses)
      add(m_mechanism.gearMeshes[mesh].id, "M" + std::to_string(m_mechanism.meshLabel(mesh)), torque,
          m_report.solution().isDetermined(mesh));
  }

  /// Couplings, and balances on links: along the path that they close.
  void addHeldParts() {
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      const auto own = std::find_if(held.byJoint.begin(), held.byJoint.end(),
                                    [&](const auto& each) { return each.first == m_joint; });
      if (own == held.byJoint.end()) continue;
      if (held.balance >= 0 && m_report.problem.balances[static_cast<std::size_t>(held.balance)].inJoint())
        continue;
      const Real torque =
          Real(own->second) * m_report.solution().values[static_cast<std::size_t>(m_model.c()) + part];
      const bool isDetermined = m_report.solution().isDetermined(m_model.c() + static_cast<int>(part));
      if (held.coupling >= 0) {
        const ShiftElementId id = m_mechanism.couplings[held.coupling].id;
        add(id, "T(" + id.text() + ")", torque, isDetermined);
      } else {
        const LinkOrdinal link = m_report.problem.balances[static_cast<std::size_t>(held.balance)].link;
        add(m_mechanism.links[link].id,
            translated("T(link %1)", {std::to_string(m_mechanism.linkLabel(link))}), torque, isDetermined);
      }
    }
  }

  void addLoads() {
    StaticsProblem onLinks;
    for (const AppliedTorque& load : m_report.problem.torques)
      if (!load.place.inJoint()) onLinks.torques.push_back(load);
    onLinks.forces = m_report.problem.forces;
    const Real torque = LoadPower::of(m_mechanism, m_model, m_placement, onLinks).byJoint.at(m_joint);
    if (!torque.isZero()) add({}, translated("loads"), torque);
  }

  void describe() {
    std::vector<std::string> links;
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link)
      if (isBeyond(link)) links.push_back(std::to_string(m_mechanism.linkLabel(link)));
    std::vector<std::string> meshes;
    std::string symbols;
    std::string numbers;
    bool isDetermined = true;
    for (const CutsetTerm& term : m_words.terms) {
      if (term.element.kind == ElementKind::gearMesh) meshes.push_back(term.symbol.substr(1));
      symbols += (symbols.empty() ? "" : " + ") + term.symbol;
      const std::string number = shownReal(term.torque.sign() < 0 ? -term.torque : term.torque);
      const bool isNegative = term.torque.sign() < 0;
      if (numbers.empty()) {
        numbers = (isNegative ? "-" : "") + number;
      } else {
        numbers += (isNegative ? " - " : " + ") + number;
      }
      isDetermined = isDetermined && term.isDetermined;
    }
    m_words.sentence = sentenceOf(std::to_string(m_mechanism.jointLabel(m_joint)), links, meshes);
    m_words.equation = equationOf(symbols, numbers, isDetermined);
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const StaticsReport& m_report;
  int m_joint;
  int m_sense = 1;  ///< +1 where the head is beyond
  ByLink<char> m_isBeyond;
  CutsetWords m_words;
};

}  // namespace

std::vector<ElementId> CutsetWords::elements() const {
  std::vector<ElementId> all = beyond;
  for (const CutsetTerm& term : terms)
    if (!term.element.id.empty()) all.push_back(term.element);
  return all;
}

std::optional<CutsetWords> cutsetWords(const Mechanism& mechanism, const KinematicModel& model,
                                       const Placement& placement, const StaticsReport& report,
                                       JointOrdinal joint) {
  if (!report.isAnswered()) return std::nullopt;
  return Cutset(mechanism, model, placement, report, joint).words();
}

std::optional<std::string> driverSentence(const Mechanism& mechanism, const Placement& placement,
                                          const StaticsReport& report, MeshOrdinal mesh) {
  if (!report.isAnswered() || !report.motion) return std::nullopt;
  const auto at = static_cast<std::size_t>(mesh);
  const MeshGeometry& geometry = *placement.meshes[at];
  const auto label = [&](LinkOrdinal link) { return std::to_string(mechanism.linkLabel(link)); };
  const std::string name = std::to_string(mechanism.meshLabel(mesh));
  if (!report.solution().isDetermined(mesh))
    return translated("Which gear drives in mesh %1 depends on how the load is shared.", {name});
  const std::string carrier = label(geometry.carrier);
  const bool isFixed = geometry.carrier == 0;
  const Real& power = report.powers.mesh[at];
  if (power.isZero()) {
    if (report.powers.rolls[at] != 0)
      return isFixed
                 ? translated("No gear drives in mesh %1: seen from the ground, it bears no load.", {name})
                 : translated("No gear drives in mesh %1: seen from carrier %2, it bears no load.",
                              {name, carrier});
    return isFixed ? translated("No gear drives in mesh %1: seen from the ground, it does not roll.", {name})
                   : translated("No gear drives in mesh %1: seen from carrier %2, it does not roll.",
                                {name, carrier});
  }
  const bool tailDrives = power.sign() > 0;
  const std::string driver = label(tailDrives ? geometry.tail : geometry.head);
  const std::string driven = label(tailDrives ? geometry.head : geometry.tail);
  const std::string watts = shownNumber(power.sign() > 0 ? power.number() : -power.number());
  return isFixed
             ? translated(
                   "Gear %1 drives gear %2 in mesh %3: seen from the ground, it turns against the teeth's "
                   "torque on it and passes %4 W.",
                   {driver, driven, name, watts})
             : translated(
                   "Gear %1 drives gear %2 in mesh %3: seen from carrier %5, it turns against the teeth's "
                   "torque on it and passes %4 W.",
                   {driver, driven, name, watts, carrier});
}

}  // namespace geargraph
