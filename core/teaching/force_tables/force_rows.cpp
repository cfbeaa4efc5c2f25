// What the tables of statics hold.

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/position_index.h"
#include "core/foundations/base/text_lists.h"
#include "core/mechanism/model/load_edits.h"
#include "core/teaching/force_tables/spoken_cell.h"

namespace geargraph {
namespace {

constexpr const char* kShared =
    toTranslate("shared");  // by several, in proportions that statics does not decide

ForceColumn text(const char* head, const char* meaning) {
  return wordedColumn(head, "", meaning, false);
}
/// As a fraction where it is one; `decimalFollows`: the next column has it as a decimal.
ForceColumn exact(const char* head, const char* unit, const char* meaning, bool decimalFollows = true) {
  return wordedColumn(head, unit, meaning, true, decimalFollows);
}
ForceColumn number(const char* head, const char* unit, const char* meaning) {
  return wordedColumn(head, unit, meaning, true);
}

class Rows {
 public:
  Rows(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
       const StaticsReport& report)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_report(report),
        m_isAnswered(report.isAnswered()) {}

  void fill(ForceTable& table) {
    m_table = &table;
    switch (table.kind) {
      case ForceTableKind::needs:
        return needs();
      case ForceTableKind::joints:
        return joints();
      case ForceTableKind::couplings:
        return couplings();
      case ForceTableKind::meshes:
        return meshes();
      case ForceTableKind::bearings:
        return bearings();
      case ForceTableKind::powers:
        return powers();
      case ForceTableKind::circulations:
        return circulations();
      case ForceTableKind::states:
        break;
    }
    GEARGRAPH_REQUIRE(false);
  }

 private:
  ForceRow& row(std::vector<ElementId> elements) {
    ForceRow& row = m_table->rows.emplace_back();
    row.elements = std::move(elements);
    return row;
  }
  static ForceCell cell(std::string text) { return {std::move(text), std::nullopt, {}}; }
  static ForceCell cell(double value) { return {shownNumber(value), value, {}}; }
  /// A word that is marked by toTranslate().
  static ForceCell wordCell(const char* word) {
    return spokenCell([word] { return translated(word); });
  }
  /// A marked text about an element, whose label or name is %1.
  static ForceCell nameCell(const char* text, const std::string& name) {
    return spokenCell([&] { return filled(translated(text), {name}); });
  }
  static ForceCell exactCell(const std::optional<Real>& value) {
    return value ? ForceCell{shownReal(*value), value->number(), {}} : wordCell(kShared);
  }
  static ForceCell decimalCell(const std::optional<Real>& value) {
    return value ? cell(value->number()) : wordCell(kShared);
  }

  [[nodiscard]] ElementId jointId(JointOrdinal joint) const { return m_mechanism.turningJoints[joint].id; }
  [[nodiscard]] ElementId linkId(LinkOrdinal link) const { return m_mechanism.links[link].id; }
  [[nodiscard]] ElementId meshId(MeshOrdinal mesh) const { return m_mechanism.gearMeshes[mesh].id; }
  /// "1 sun", "0".
  [[nodiscard]] std::string linkName(LinkOrdinal link) const {
    const std::string& name = m_mechanism.links[link].name;
    return std::to_string(m_mechanism.linkLabel(link)) + (name.empty() ? "" : " " + name);
  }

  /// The value of an unknown in a solution; none where it is not determined.
  static std::optional<Real> valueIn(const StaticsSolution& solution, int unknown) {
    if (!solution.isDetermined(unknown)) return std::nullopt;
    return solution.values[static_cast<std::size_t>(unknown)];
  }

  /// What loads and balances put into each joint in a solution; none where a balance is not determined.
  [[nodiscard]] std::vector<std::optional<Real>> torquesIn(const StaticsSolution& solution) const {
    ByJoint<std::optional<Real>> torques(static_cast<std::size_t>(m_model.t()), Real());
    for (const AppliedTorque& load : m_report.problem.torques)
      if (load.place.inJoint()) *torques[load.place.joint] += Real(load.torque);
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int balance = m_report.held[part].balance;
      if (balance < 0) continue;
      const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(balance)];
      if (!place.inJoint()) continue;
      auto& torque = torques[place.joint];
      const auto found = valueIn(solution, m_model.c() + static_cast<int>(part));
      if (!found) {
        torque.reset();
      } else if (torque) {
        *torque += *found;
      }
    }
    return torques;
  }

  /// What has to be provided: where torques are given, where they are found, and what is engaged.
  void needs() {
    m_table->columns = {
        text(toTranslate("at"),
             toTranslate("The joint, the link, the brake or the clutch that a torque acts in or on.")),
        text(
            toTranslate("link"),
            toTranslate("The link that the torque acts on, and for a clutch the one that has the reaction.")),
        text(toTranslate("part in it"),
             toTranslate(
                 "A motor turns a joint at a given speed, or holds it; its torque is given or found. A "
                 "load is given, a balance is found. A brake holds its link, a clutch joins two.")),
        exact(toTranslate("exact torque"), "N m",
              toTranslate("The torque on that link, with the losses where they are given.")),
        number(toTranslate("torque"), "N m", toTranslate("The same as a decimal.")),
        number(toTranslate("rate"), "rad/s", toTranslate("How fast it turns about its axis.")),
        number(toTranslate("power"), "W",
               toTranslate("Torque times rate: what is fed into the train here; below 0: what is taken. A "
                           "clutch passes power between its links, a brake passes none.")),
    };
    if (!m_isAnswered) return;
    const auto torques = torquesIn(m_report.solution());
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      const bool isGiven = isLoaded(joint);
      const bool isFound = isBalance(joint);
      if (!isGiven && !isFound) continue;
      const auto& torque = torques[static_cast<std::size_t>(joint)];
      const LinkOrdinal child = m_model.tree().child(joint);
      ForceRow& line = row({jointId(joint), linkId(child)});
      line.cells = {nameCell(toTranslate("joint %1"), std::to_string(m_mechanism.jointLabel(joint))),
                    cell(linkName(child)), wordCell(jointPart(joint, isGiven, isFound)), exactCell(torque),
                    decimalCell(torque)};
      const auto rate = m_report.rateOf(joint);
      line.cells.push_back(rate ? cell(rate->toDouble()) : ForceCell());
      line.cells.push_back(!rate    ? ForceCell()
                           : torque ? cell((*torque * Real(*rate)).number())
                                    : wordCell(kShared));
    }
    needsOnLinks();
    needsOfCouplings();
  }

  [[nodiscard]] bool isLoaded(JointOrdinal joint) const {
    const auto& torques = m_report.problem.torques;
    return std::any_of(torques.begin(), torques.end(),
                       [joint](const AppliedTorque& each) { return each.place.joint == joint; });
  }
  [[nodiscard]] bool isBalance(JointOrdinal joint) const {
    const auto& places = m_report.problem.balances;
    return std::any_of(places.begin(), places.end(),
                       [joint](const TorquePlace& each) { return each.joint == joint; });
  }
  /// Where the document states no inputs, the balances are at those that were chosen.
  [[nodiscard]] bool isMotor(JointOrdinal joint, bool isFound) const {
    if (!m_mechanism.inputs) return isFound && !m_mechanism.balances;
    const JointId id = m_mechanism.turningJoints[joint].id;
    return std::any_of(m_mechanism.inputs->begin(), m_mechanism.inputs->end(),
                       [&id](const Input& each) { return each.joint == id; });
  }
  [[nodiscard]] const char* jointPart(JointOrdinal joint, bool isGiven, bool isFound) const {
    if (isGiven && isFound) return toTranslate("load and balance");
    if (isMotor(joint, isFound)) {
      const auto rate = m_report.rateOf(joint);
      if (!isGiven && rate && rate->isZero()) return toTranslate("held, found");
      return isGiven ? toTranslate("motor, given") : toTranslate("motor, found");
    }
    return isGiven ? toTranslate("load") : toTranslate("balance, found");
  }

  /// The drive of a state is its motor.
  [[nodiscard]] const char* linkPart(const LinkId& link, bool isGiven) const {
    const bool isDriven =
        m_report.state >= 0 && m_mechanism.states[static_cast<std::size_t>(m_report.state)].drive == link;
    if (isDriven) return isGiven ? toTranslate("motor, given") : toTranslate("motor, found");
    return isGiven ? toTranslate("load") : toTranslate("balance, found");
  }

  void needsOnLinks() {
    for (const LoadReport& load : m_report.loads) {
      const auto link = linkOf(load.load);
      if (!link) continue;
      const auto* torque = std::get_if<LinkTorque>(&load.load.action);
      if (torque == nullptr) {
        addNeedOnLink(m_links.at(*link), toTranslate("force"), {}, load.watts);
      } else {
        addNeedOnLink(m_links.at(*link), linkPart(*link, true), exactCell(Real(torque->torque.exact())),
                      load.watts);
      }
    }
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int balance = m_report.held[part].balance;
      if (balance < 0) continue;
      const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(balance)];
      if (place.inJoint()) continue;
      const auto torque = valueIn(m_report.solution(), m_model.c() + static_cast<int>(part));
      const bool hasPower = m_report.motion && torque;
      addNeedOnLink(place.link, linkPart(m_mechanism.links[place.link].id, false), exactCell(torque),
                    hasPower ? std::optional(m_report.powers.held[part]) : std::nullopt);
    }
  }

  /// How fast a link turns about the torque's axis, its power tells.
  void addNeedOnLink(LinkOrdinal link, const char* part, const ForceCell& torque,
                     const std::optional<Real>& watts) {
    ForceRow& line = row({linkId(link)});
    const bool turns = watts && torque.number && *torque.number != 0;
    line.cells = {nameCell(toTranslate("link %1"), std::to_string(m_mechanism.linkLabel(link))),
                  cell(linkName(link)),
                  wordCell(part),
                  torque,
                  torque.number ? cell(*torque.number) : torque,
                  turns ? cell(watts->number() / *torque.number) : ForceCell(),
                  watts ? cell(watts->number()) : ForceCell()};
  }

  void needsOfCouplings() {
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      if (held.coupling < 0 || !held.isMain) continue;
      const ShiftElement& coupling = m_mechanism.couplings[held.coupling];
      ForceRow& line = row(elementsOf(coupling));
      const auto torque = valueIn(m_report.solution(), m_model.c() + static_cast<int>(part));
      line.cells = {nameCell(couplingText(coupling), coupling.id.text()),
                    cell(linksOf(coupling)),
                    wordCell(coupling.kind == ShiftElementKind::brake    ? toTranslate("holds")
                             : coupling.kind == ShiftElementKind::clutch ? toTranslate("joins")
                                                                         : toTranslate("locked")),
                    exactCell(torque),
                    decimalCell(torque),
                    coupling.kind == ShiftElementKind::brake ? cell(0.0) : ForceCell(),
                    m_report.flow
                        ? flowCell(m_report.flow->of(ElementPower::Kind::coupling, held.coupling), 0)
                        : ForceCell()};
    }
  }

  [[nodiscard]] static std::vector<ElementId> elementsOf(const ShiftElement& coupling) {
    std::vector<ElementId> elements{ElementId(coupling.id)};
    elements.insert(elements.end(), coupling.links.begin(), coupling.links.end());
    return elements;
  }
  [[nodiscard]] std::string linksOf(const ShiftElement& coupling) const {
    std::string links;
    for (const LinkId& link : coupling.links)
      links += (links.empty() ? "" : ", ") + linkName(m_links.at(link));
    return links;
  }

  static const char* carriedBy(bool load, bool balance) {
    if (load) return balance ? toTranslate("load and balance") : toTranslate("load");
    return balance ? toTranslate("balance") : toTranslate("free");
  }

  void joints() {
    m_table->columns = {
        text(toTranslate("at"),
             toTranslate(
                 "A turning joint, by its label, or a link on which a load or a balance acts from outside.")),
        text(toTranslate("turns"), toTranslate("The link beyond the joint, seen from the ground.")),
        text(toTranslate("carried by"),
             toTranslate("What puts a torque in: a load that is given, a balance that is found, or "
                         "nothing: a free joint.")),
        exact(toTranslate("lossless"), "N m",
              toTranslate("The torque that the joint's tail exerts on its head about the axis, of a "
                          "train without losses."),
              false),
        exact(toTranslate("exact torque"), "N m",
              toTranslate("The same with the losses of the meshes, where they are given.")),
        number(toTranslate("torque"), "N m", toTranslate("The same as a decimal.")),
        number(toTranslate("rate"), "rad/s", toTranslate("How fast the head turns against the tail.")),
        number(toTranslate("power"), "W",
               toTranslate("Torque times rate: what load or balance feed into the train here; below 0: "
                           "what they take.")),
    };
    if (!m_isAnswered) return;
    ByJoint<std::pair<bool, bool>> carried(static_cast<std::size_t>(m_model.t()));  // load, balance
    for (const AppliedTorque& load : m_report.problem.torques)
      if (load.place.inJoint()) carried[load.place.joint].first = true;
    for (const TorquePlace& place : m_report.problem.balances)
      if (place.inJoint()) carried[place.joint].second = true;
    const auto lossless = torquesIn(m_report.lossless);
    const auto torques = torquesIn(m_report.solution());
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      const auto at = static_cast<std::size_t>(joint);
      const LinkOrdinal child = m_model.tree().child(joint);
      ForceRow& line = row({jointId(joint), linkId(child)});
      const auto [load, balance] = carried[at];
      line.cells = {cell(std::to_string(m_mechanism.jointLabel(joint))),
                    cell(linkName(child)),
                    wordCell(carriedBy(load, balance)),
                    exactCell(lossless[at]),
                    exactCell(torques[at]),
                    decimalCell(torques[at])};
      if (const auto rate = m_report.rateOf(joint)) {
        line.cells.push_back(cell(rate->toDouble()));
        line.cells.push_back(torques[at] ? cell((*torques[at] * Real(*rate)).number()) : wordCell(kShared));
      } else {
        line.cells.resize(m_table->columns.size());
      }
    }
    addOutside();
  }

  /// What acts on links from outside, below the joints.
  void addOutside() {
    for (const LoadReport& load : m_report.loads) {
      const auto link = linkOf(load.load);
      if (!link) continue;
      const auto* torque = std::get_if<LinkTorque>(&load.load.action);
      std::optional<Real> size;
      if (torque != nullptr) size = Real(torque->torque.exact());
      addOnLink(m_links.at(*link), torque != nullptr ? toTranslate("load") : toTranslate("force"), size, size,
                load.watts);
    }
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int balance = m_report.held[part].balance;
      if (balance < 0) continue;
      const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(balance)];
      if (place.inJoint()) continue;
      const int unknown = m_model.c() + static_cast<int>(part);
      const bool isKnown = m_report.solution().isDetermined(unknown);
      addOnLink(place.link, toTranslate("balance"), valueIn(m_report.lossless, unknown),
                valueIn(m_report.solution(), unknown),
                m_report.motion && isKnown ? std::optional(m_report.powers.held[part]) : std::nullopt);
    }
  }

  void addOnLink(LinkOrdinal link, const char* by, const std::optional<Real>& lossless,
                 const std::optional<Real>& torque, const std::optional<Real>& watts) {
    ForceRow& line = row({linkId(link)});
    const bool isForce = std::string_view(by) == "force";
    line.cells = {nameCell(toTranslate("link %1"), std::to_string(m_mechanism.linkLabel(link))),
                  cell(linkName(link)),
                  wordCell(by),
                  isForce ? cell("") : exactCell(lossless),
                  isForce ? cell("") : exactCell(torque),
                  isForce ? cell("") : decimalCell(torque),
                  cell(""),
                  watts ? cell(watts->number()) : cell("")};
  }

  void couplings() {
    m_table->columns = {
        text(toTranslate("coupling"), toTranslate("A brake or clutch that is engaged.")),
        text(toTranslate("holds"),
             toTranslate("The link that a brake holds; the two links that a clutch joins, the torque acts on "
                         "the first one.")),
        text(toTranslate("about"),
             toTranslate("The axis that the torque is about, the first one on the way to the ground.")),
        exact(toTranslate("exact torque"), "N m",
              toTranslate("The torque on that link, with the losses where they are given.")),
        number(toTranslate("torque"), "N m", toTranslate("The same as a decimal.")),
        number(toTranslate("passed"), "W",
               toTranslate("The power that a clutch delivers to the first link; a brake passes none.")),
    };
    if (!m_isAnswered) return;
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      if (held.coupling < 0) continue;
      const ShiftElement& coupling = m_mechanism.couplings[held.coupling];
      const auto torque = valueIn(m_report.solution(), m_model.c() + static_cast<int>(part));
      ForceRow& line = row(elementsOf(coupling));
      line.cells = {nameCell(couplingText(coupling), coupling.id.text()), cell(linksOf(coupling)),
                    cell(m_mechanism.axes[held.axis].id.text()), exactCell(torque), decimalCell(torque)};
      line.cells.push_back(held.isMain && m_report.flow
                               ? flowCell(m_report.flow->of(ElementPower::Kind::coupling, held.coupling), 0)
                               : ForceCell());
    }
  }

  static ForceCell flowCell(const ElementPower& element, std::size_t port) {
    return element.isDetermined ? cell(element.ports[port].power.number()) : wordCell(kShared);
  }

  void meshes() {
    m_table->columns = {
        text(toTranslate("mesh"), toTranslate("The gear mesh, by its label.")),
        text(toTranslate("tail"), toTranslate("The link of the tail's gear.")),
        text(toTranslate("head"), toTranslate("The link of the head's gear.")),
        text(toTranslate("carrier"),
             toTranslate("The link that holds both gears' axes, from which the mesh is seen.")),
        exact(toTranslate("on tail"), "N m",
              toTranslate("The torque of the mesh on the tail's gear about its own axis, seen from the "
                          "carrier."),
              false),
        exact(toTranslate("on head"), "N m",
              toTranslate("The torque of the mesh on the head's gear about its own axis, seen from the "
                          "carrier."),
              false),
        number(toTranslate("tangential"), "N",
               toTranslate("The force along the pitch circles' tangent, of the tail's gear on the "
                           "head's.")),
        number(toTranslate("separating"), "N",
               toTranslate("The force that presses the gears apart: the tangential one times the "
                           "tangent of the operating pressure angle.")),
        number("Fx", "N", toTranslate("The whole tooth force on the head's gear, in the base frame.")),
        number("Fy", "N", toTranslate("The whole tooth force on the head's gear, in the base frame.")),
        number("Fz", "N", toTranslate("The whole tooth force on the head's gear, in the base frame.")),
        number(toTranslate("efficiency"), "",
               toTranslate("Power delivered over power taken, seen from the carrier.")),
        text(toTranslate("drives"),
             toTranslate("The gear that delivers the power to the teeth, seen from the carrier.")),
        number(toTranslate("rolling power"), "W",
               toTranslate("What the teeth pass from tail to head, seen from the carrier: the "
                           "latent power.")),
        number(toTranslate("lost"), "W", toTranslate("One minus the efficiency, times the rolling power.")),
        number(toTranslate("to tail"), "W",
               toTranslate("What the mesh delivers to the tail's gear, seen from the ground.")),
        number(toTranslate("to head"), "W",
               toTranslate("What the mesh delivers to the head's gear, seen from the ground.")),
        number(toTranslate("to carrier"), "W",
               toTranslate("What the mesh delivers to the carrier, seen from the ground.")),
    };
    GEARGRAPH_REQUIRE(m_table->columns.size() == static_cast<std::size_t>(MeshColumn::count));
    if (!m_isAnswered) return;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) addMesh(mesh);
  }

  void addMesh(MeshOrdinal mesh) {
    const auto at = static_cast<std::size_t>(mesh);
    const MeshGeometry& geometry = *m_placement.meshes[at];
    ForceRow& line = row({meshId(mesh), linkId(geometry.tail), linkId(geometry.head)});
    const bool isDetermined = m_report.solution().isDetermined(mesh);
    const PortTorques ports = portTorques(m_model, m_report.solution(), m_report.losses(), mesh);
    const auto torque = [&](const Real& size, int gear, AxisGroupOrdinal axisGroup) {
      if (!isDetermined) return wordCell(kShared);
      return exactCell(Real(orientationSignAt(m_placement, gear, axisGroup)) * size);
    };
    line.cells = {cell(std::to_string(m_mechanism.meshLabel(mesh))),
                  cell(linkName(geometry.tail)),
                  cell(linkName(geometry.head)),
                  cell(linkName(geometry.carrier)),
                  torque(ports.tail, geometry.tail, geometry.tailClass),
                  torque(ports.head, geometry.head, geometry.headClass)};
    if (m_report.forces.meshes.empty()) {
      line.cells.resize(line.cells.size() + 5);
    } else {
      const ToothForce& force = m_report.forces.meshes[at];
      for (const double size :
           {force.tangential, force.separating, force.force[0], force.force[1], force.force[2]})
        line.cells.push_back(isDetermined ? cell(size) : wordCell(kShared));
    }
    addMeshPower(mesh, isDetermined, line);
    line.cells.resize(m_table->columns.size());
  }

  void addMeshPower(MeshOrdinal mesh, bool isDetermined, ForceRow& line) {
    const auto at = static_cast<std::size_t>(mesh);
    if (!m_report.flow) return;
    if (!isDetermined) {
      for (int i = 0; i < 7; ++i) line.cells.push_back(wordCell(kShared));
      return;
    }
    const MeshGeometry& geometry = *m_placement.meshes[at];
    const MeshLoss loss = m_report.losses().empty() ? MeshLoss{} : m_report.losses()[at];
    const bool loses = loss.driver != MeshLoss::Driver::none;
    const Real& power = m_report.powers.mesh[at];
    const ElementPower& flow = m_report.flow->of(ElementPower::Kind::mesh, mesh);
    line.cells.push_back(m_report.losses().empty() ? ForceCell()
                                                   : cell(loses ? loss.efficiency.toDouble() : 1.0));
    line.cells.push_back(power.isZero() ? cell("")
                                        : cell(linkName(power.sign() > 0 ? geometry.tail : geometry.head)));
    line.cells.push_back(cell(power.number()));
    line.cells.push_back(cell((-flow.fed()).number()));
    for (std::size_t port = 0; port < 3; ++port) line.cells.push_back(flowCell(flow, port));
  }

  void bearings() {
    m_table->columns = {
        text(toTranslate("joint"),
             toTranslate("The turning joint, whose bearing holds its head on its tail.")),
        text(toTranslate("turns"), toTranslate("The link beyond the joint, seen from the ground.")),
        number(toTranslate("force"), "N", toTranslate("The size of the force of the tail on the head.")),
        number("Fx", "N", toTranslate("The force of the tail on the head, in the base frame.")),
        number("Fy", "N", toTranslate("The force of the tail on the head, in the base frame.")),
        number("Fz", "N", toTranslate("The force of the tail on the head, in the base frame.")),
        number("Mx", "N m",
               toTranslate("The moment of the tail on the head about the point, with the joint's own "
                           "torque.")),
        number("My", "N m",
               toTranslate("The moment of the tail on the head about the point, with the joint's own "
                           "torque.")),
        number("Mz", "N m",
               toTranslate("The moment of the tail on the head about the point, with the joint's own "
                           "torque.")),
        number("x", "",
               toTranslate("Where the joint is drawn: the point that the moment is about, in the document's "
                           "unit.")),
        number("y", "", toTranslate("Where the joint is drawn, in the document's unit.")),
        number("z", "", toTranslate("Where the joint is drawn, in the document's unit.")),
    };
    m_table->columns[1].isInFiles = false;
    for (std::size_t i = 9; i < 12; ++i) m_table->columns[i].unit = m_mechanism.unit;
    if (!m_isAnswered) return;
    for (std::size_t joint = 0; joint < m_report.forces.bearings.size(); ++joint) {
      const BearingReaction& bearing = m_report.forces.bearings[joint];
      ForceRow& line = row({jointId(static_cast<int>(joint))});
      line.cells = {cell(std::to_string(m_mechanism.jointLabel(static_cast<int>(joint)))),
                    cell(linkName(m_model.tree().child(static_cast<int>(joint)))),
                    bearing.isDetermined ? cell(length(bearing.force)) : wordCell(kShared)};
      for (const Vector3& vector : {bearing.force, bearing.moment})
        for (const double component : vector)
          line.cells.push_back(bearing.isDetermined ? cell(component) : wordCell(kShared));
      for (const double component : bearing.point) line.cells.push_back(cell(component));
    }
  }

  void powers() {
    m_table->columns = {
        text(toTranslate("element"),
             toTranslate("A mesh, a joint, an engaged coupling, a load or a balance.")),
        text(toTranslate("link"), toTranslate("The link that it acts on.")),
        exact(toTranslate("exact power"), "W",
              toTranslate("What the element delivers to the link, seen from the ground; below 0: what it "
                          "takes from it. The sum at every link is 0.")),
        number(toTranslate("power"), "W", toTranslate("The same as a decimal.")),
        number(toTranslate("part"), "%", toTranslate("Of the power fed into the train.")),
    };
    if (!m_isAnswered || !m_report.flow) return;
    const double fed = m_report.sums ? m_report.sums->fed.number() : 0;
    for (const ElementPower& element : m_report.flow->elements) {
      if (element.isDetermined && std::all_of(element.ports.begin(), element.ports.end(),
                                              [](const PowerPort& port) { return port.power.isZero(); }))
        continue;  // a free joint that passes nothing, a brake
      for (const PowerPort& port : element.ports) {
        std::vector<ElementId> elements = elementsOf(element);
        elements.push_back(linkId(port.link));
        ForceRow& line = row(std::move(elements));
        const auto power = element.isDetermined ? std::optional(port.power) : std::nullopt;
        line.cells = {nameOf(element), cell(linkName(port.link)), exactCell(power), decimalCell(power),
                      power && fed > 0 ? cell(100 * power->number() / fed) : cell("")};
      }
    }
  }

  [[nodiscard]] std::vector<ElementId> elementsOf(const ElementPower& element) const {
    switch (element.kind) {
      case ElementPower::Kind::mesh:
        return {meshId(element.position)};
      case ElementPower::Kind::joint:
        return {jointId(element.position)};
      case ElementPower::Kind::coupling:
        return {ElementId(m_mechanism.couplings[element.position].id)};
      case ElementPower::Kind::load:
      case ElementPower::Kind::balance:
        break;
    }
    return {};
  }
  static const char* couplingText(const ShiftElement& coupling) {
    if (coupling.kind == ShiftElementKind::freewheel) return toTranslate("freewheel %1");
    return coupling.kind == ShiftElementKind::brake ? toTranslate("brake %1") : toTranslate("clutch %1");
  }
  [[nodiscard]] ForceCell nameOf(const ElementPower& element) const {
    switch (element.kind) {
      case ElementPower::Kind::mesh:
        return nameCell(toTranslate("mesh %1"), std::to_string(m_mechanism.meshLabel(element.position)));
      case ElementPower::Kind::joint:
        return nameCell(toTranslate("joint %1"), std::to_string(m_mechanism.jointLabel(element.position)));
      case ElementPower::Kind::coupling: {
        const ShiftElement& coupling = m_mechanism.couplings[element.position];
        return nameCell(couplingText(coupling), coupling.id.text());
      }
      case ElementPower::Kind::load:
        return nameCell(toTranslate("load on link %1"),
                        std::to_string(m_mechanism.linkLabel(element.ports.front().link)));
      case ElementPower::Kind::balance:
        return nameCell(toTranslate("balance on link %1"),
                        std::to_string(m_mechanism.linkLabel(element.ports.front().link)));
    }
    return {};
  }

  void circulations() {
    m_table->columns = {
        exact(toTranslate("exact power"), "W",
              toTranslate("The least power on the loop: what goes round beside what goes through.")),
        number(toTranslate("power"), "W", toTranslate("The same as a decimal.")),
        number(toTranslate("part"), "%", toTranslate("Of the power fed into the train.")),
        text(toTranslate("links"), toTranslate("The shafts of the loop.")),
        text(toTranslate("meshes"), toTranslate("The meshes of the gear sets of the loop.")),
    };
    if (!m_report.circulations) return;
    const double fed = m_report.sums ? m_report.sums->fed.number() : 0;
    for (const Circulation& each : *m_report.circulations) {
      std::vector<ElementId> elements;
      std::vector<std::string> links;
      std::vector<std::string> labels;
      for (const LinkOrdinal link : each.links) {
        elements.push_back(linkId(link));
        links.push_back(linkName(link));
      }
      for (const MeshOrdinal mesh : each.meshes) {
        elements.push_back(meshId(mesh));
        labels.push_back(std::to_string(m_mechanism.meshLabel(mesh)));
      }
      ForceRow& line = row(std::move(elements));
      line.cells = {exactCell(each.power), decimalCell(each.power),
                    fed > 0 ? cell(100 * each.power.number() / fed) : cell(""),
                    spokenCell([&] { return listed(links, kAllNames); }),
                    spokenCell([&] { return listed(labels, kAllNames); })};
    }
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const StaticsReport& m_report;
  bool m_isAnswered;
  PositionIndex<LinkTag> m_links{m_mechanism.links};
  ForceTable* m_table = nullptr;
};

}  // namespace

ForceTable forceTable(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                      const StaticsReport& report, ForceTableKind kind) {
  ForceTable table;
  table.kind = kind;
  Rows(mechanism, model, placement, report).fill(table);
  return table;
}

}  // namespace geargraph
