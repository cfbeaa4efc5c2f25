#include "core/presentation/result_json/statics_json.h"

#include <string>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/load_edits.h"
#include "core/presentation/result_json/diagnostics_json.h"
#include "core/presentation/result_json/torque_matrix_json.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

/// Writes the parts of one report, a function a part.
class StaticsJson {
 public:
  StaticsJson(JsonWriter& json, const AnalysisSnapshot& snapshot, const StaticsReport& report)
      : m_json(json),
        m_mechanism(*snapshot.mechanism),
        m_model(*snapshot.kinematics->model),
        m_placement(snapshot.kinematics->placement()),
        m_report(report),
        m_solution(report.solution()),
        m_isAnswered(report.isAnswered()) {}

  void write() {
    engaged();
    const bool isAsked = m_report.sharing == LoadSharing::stiffness;
    m_json.member("share",
                  loadSharingName(isAsked || m_report.isShared ? LoadSharing::stiffness : LoadSharing::none));
    m_json.member("shareAssumed", m_report.isShared && !isAsked);
    part("speeds", m_report.motion.has_value(), &StaticsJson::speeds);
    part("counts", m_report.isSolved, &StaticsJson::counts);
    part("loads", true, &StaticsJson::loads);
    part("balances", m_isAnswered, &StaticsJson::balances);
    part("jointTorques", m_isAnswered, &StaticsJson::jointTorques);
    part("couplings", m_isAnswered, &StaticsJson::couplings);
    part("meshes", m_isAnswered, &StaticsJson::meshes);
    part("bearings", m_isAnswered && !m_report.forces.bearings.empty(), &StaticsJson::bearings);
    part("selfStresses", m_report.isSolved, &StaticsJson::selfStresses);
    part("power", m_report.sums.has_value(), &StaticsJson::power);
    part("jointPowers", m_report.flow.has_value(), &StaticsJson::jointPowers);
    part("efficiency", m_report.lossy && m_report.lossy->outcome != LossySolution::Outcome::undecided,
         &StaticsJson::efficiency);
    part("solution", m_report.matrix.has_value(), &StaticsJson::matrix);
    part("ttSolution", m_report.ttMatrix.has_value(), &StaticsJson::ttMatrix);
    part("agreement", m_report.agreement.has_value(), &StaticsJson::agreement);
  }

 private:
  void part(std::string_view name, bool isDefined, void (StaticsJson::*writePart)()) {
    m_json.key(name);
    isDefined ? (this->*writePart)() : m_json.null();
  }

  /// A fraction as a text, what is not exact as a number.
  void real(const Real& value) {
    value.isExact() ? m_json.string(value.fraction()->toString()) : m_json.numberOrNull(value.number());
  }
  void member(std::string_view name, const Real& value) {
    m_json.key(name);
    real(value);
  }
  void member(std::string_view name, const std::optional<Real>& value) {
    m_json.key(name);
    value ? real(*value) : m_json.null();
  }
  void null(std::string_view name) {
    m_json.key(name);
    m_json.null();
  }
  void vector(std::string_view name, const Vector3& value) {
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const double component : value) m_json.numberOrNull(component);
    m_json.endArray();
  }
  void labels(std::string_view name, std::span<const int> ordinals, int (Mechanism::*label)(int) const) {
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const int each : ordinals) m_json.number(static_cast<std::int64_t>((m_mechanism.*label)(each)));
    m_json.endArray();
  }
  [[nodiscard]] const Real& value(int unknown) const {
    return m_solution.values[static_cast<std::size_t>(unknown)];
  }
  [[nodiscard]] int unknownOf(std::size_t part) const { return m_model.c() + static_cast<int>(part); }
  /// null where it is not determined.
  [[nodiscard]] std::optional<Real> determined(int unknown, const Real& number) const {
    return m_solution.isDetermined(unknown) ? std::optional(number) : std::nullopt;
  }
  [[nodiscard]] std::string axisId(AxisOrdinal axis) const { return m_mechanism.axes[axis].id.text(); }

  void engaged() {
    m_json.key("engaged");
    m_json.beginArray(Layout::row);
    for (const ShiftElementOrdinal coupling : m_report.problem.engaged)
      m_json.string(m_mechanism.couplings[coupling].id.text());
    m_json.endArray();
  }

  void speeds() {
    m_json.beginObject(Layout::row);
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      m_json.key(std::to_string(m_mechanism.jointLabel(joint)));
      const auto rate = m_report.rateOf(joint);
      rate ? m_json.string(rate->toString()) : m_json.null();
    }
    m_json.endObject();
  }

  void counts() {
    m_json.beginObject(Layout::row);
    m_json.member("unknowns", m_report.lossless.unknowns);
    m_json.member("equations", m_report.lossless.equations);
    m_json.member("rank", m_report.lossless.rank);
    m_json.member("indeterminate", m_report.lossless.indeterminate());
    m_json.endObject();
  }

  void loads() {
    m_json.beginArray();
    for (const LoadReport& report : m_report.loads) {
      m_json.beginObject(Layout::row);
      if (!report.load.id.empty()) m_json.member("id", report.load.id.text());
      const auto triple = [&](std::string_view name, const NumberTriple& numbers) {
        m_json.key(name);
        m_json.beginArray(Layout::row);
        for (const Number& number : numbers) m_json.string(number.exact().toString());
        m_json.endArray();
      };
      if (const auto* inJoint = std::get_if<JointTorque>(&report.load.action)) {
        m_json.member("joint", m_mechanism.jointLabel(m_joints.at(inJoint->joint)));
        m_json.member("torque", inJoint->torque.exact().toString());
      } else if (const auto* torque = std::get_if<LinkTorque>(&report.load.action)) {
        const LinkOrdinal link = m_links.at(torque->link);
        m_json.member("link", m_mechanism.linkLabel(link));
        m_json.member("axis", axisId(onLink(m_mechanism, m_placement, link, torque->axis).axis));
        m_json.member("torque", torque->torque.exact().toString());
      } else {
        const auto& force = std::get<LinkForce>(report.load.action);
        m_json.member("link", m_mechanism.linkLabel(m_links.at(force.link)));
        triple("force", force.force);
        triple("point", force.point);
      }
      if (report.watts) member("power", *report.watts);
      m_json.endObject();
    }
    m_json.endArray();
  }

  void balances() {
    m_json.beginArray();
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      if (held.balance < 0) continue;
      const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(held.balance)];
      m_json.beginObject(Layout::row);
      if (place.inJoint()) {
        m_json.member("joint", m_mechanism.jointLabel(place.joint));
      } else {
        m_json.member("link", m_mechanism.linkLabel(place.link));
        m_json.member("axis", axisId(place.axis));
      }
      const int unknown = unknownOf(part);
      member("torque", determined(unknown, value(unknown)));
      if (m_report.motion) member("power", determined(unknown, m_report.powers.held[part]));
      m_json.member("determinate", m_solution.isDetermined(unknown));
      assumption(part);
      m_json.endObject();
    }
    m_json.endArray();
  }

  /// Marks a torque that depends on how loads are shared, with its range under losses.
  void assumption(std::size_t part) {
    if (!m_report.isAssumed(unknownOf(part))) return;
    m_json.member("assumed", true);
    if (m_report.ranges.empty()) return;
    m_json.key("range");
    const std::optional<SharedRange>& range = m_report.ranges[part];
    if (!range) return m_json.null();
    m_json.beginArray(Layout::row);
    real(range->least);
    real(range->most);
    m_json.endArray();
  }

  /// Loads and balances in each joint; joints without any are left out.
  void jointTorques() {
    std::vector<std::optional<Real>> torques(static_cast<std::size_t>(m_model.t()), Real());
    std::vector<char> bears(torques.size(), 0);
    for (const AppliedTorque& load : m_report.problem.torques) {
      if (!load.place.inJoint()) continue;
      const auto at = static_cast<std::size_t>(load.place.joint);
      bears[at] = 1;
      *torques[at] += Real(load.torque);
    }
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int balance = m_report.held[part].balance;
      if (balance < 0) continue;
      const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(balance)];
      if (!place.inJoint()) continue;
      const auto at = static_cast<std::size_t>(place.joint);
      bears[at] = 1;
      if (!m_solution.isDetermined(unknownOf(part))) torques[at].reset();
      if (torques[at]) *torques[at] += value(unknownOf(part));
    }
    m_json.beginObject(Layout::row);
    for (std::size_t joint = 0; joint < torques.size(); ++joint)
      if (bears[joint] != 0)
        member(std::to_string(m_mechanism.jointLabel(static_cast<int>(joint))), torques[joint]);
    m_json.endObject();
  }

  void couplings() {
    m_json.beginObject();
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      if (held.coupling < 0 || !held.isMain) continue;
      const ShiftElement& coupling = m_mechanism.couplings[held.coupling];
      m_json.key(coupling.id.text());
      m_json.beginObject(Layout::row);
      m_json.member("kind", couplingKindName(coupling.kind));
      m_json.member("axis", axisId(held.axis));
      const int unknown = unknownOf(part);
      member("torque", determined(unknown, value(unknown)));
      m_json.member("determinate", m_solution.isDetermined(unknown));
      assumption(part);
      if (m_report.flow) groundPower(ElementPower::Kind::coupling, held.coupling, {"link", "against"});
      across(held.coupling);
      m_json.endObject();
    }
    m_json.endObject();
  }

  /// The components of a coupling about further directions, by axis; left out where there are none.
  void across(ShiftElementOrdinal coupling) {
    bool isOpen = false;
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const HeldPart& held = m_report.held[part];
      if (held.coupling != coupling || held.isMain) continue;
      if (!isOpen) {
        m_json.key("across");
        m_json.beginObject();
        isOpen = true;
      }
      member(axisId(held.axis), determined(unknownOf(part), value(unknownOf(part))));
    }
    if (isOpen) m_json.endObject();
  }

  void meshes() {
    m_json.beginArray();
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) writeMesh(mesh);
    m_json.endArray();
  }

  void writeMesh(MeshOrdinal mesh) {
    const auto at = static_cast<std::size_t>(mesh);
    const MeshGeometry& geometry = *m_placement.meshes[at];
    const std::span<const MeshLoss> losses = m_report.losses();
    const MeshLoss loss = losses.empty() ? MeshLoss{} : losses[at];
    const Real driven = Real(loss.driver == MeshLoss::Driver::none ? Rational(1) : loss.efficiency);
    const PortTorques ports = portTorques(m_model, m_solution, losses, mesh);
    m_json.beginObject(Layout::row);
    m_json.member("mesh", m_mechanism.meshLabel(mesh));
    m_json.member("tail", m_mechanism.linkLabel(geometry.tail));
    m_json.member("head", m_mechanism.linkLabel(geometry.head));
    m_json.member("carrier", m_mechanism.linkLabel(geometry.carrier));
    m_json.member("determinate", m_solution.isDetermined(mesh));
    if (m_report.isAssumed(mesh)) m_json.member("assumed", true);
    member("tailTorque",
           determined(mesh,
                      Real(orientationSignAt(m_placement, geometry.tail, geometry.tailClass)) * ports.tail));
    member("headTorque",
           determined(mesh,
                      Real(orientationSignAt(m_placement, geometry.head, geometry.headClass)) * ports.head));
    if (m_report.forces.meshes.empty() || !m_solution.isDetermined(mesh)) {
      null("tangentialForce");
      null("force");
    } else {
      m_json.member("tangentialForce", m_report.forces.meshes[at].tangential);
      vector("force", m_report.forces.meshes[at].force);
    }
    if (m_report.sums) writeMeshPower(mesh, loss, driven);
    m_json.endObject();
  }

  void writeMeshPower(MeshOrdinal mesh, const MeshLoss& loss, const Real& driven) {
    const Real& power = m_report.powers.mesh[static_cast<std::size_t>(mesh)];
    if (!m_report.losses().empty()) member("efficiency", driven);
    m_json.key("driver");
    if (!m_solution.isDetermined(mesh) || power.isZero()) {
      m_json.null();
    } else {
      m_json.string(power.sign() > 0 ? "tail" : "head");
    }
    member("power", determined(mesh, power));
    const Real lost = loss.driver == MeshLoss::Driver::none ? Real() : (Real(1) - driven) * power.abs();
    member("loss", determined(mesh, lost));
    groundPower(ElementPower::Kind::mesh, mesh, {"tail", "head", "carrier"});
  }

  /// What the element delivers to each link, seen from the ground.
  void groundPower(ElementPower::Kind kind, int position, std::initializer_list<std::string_view> names) {
    const ElementPower& element = m_report.flow->of(kind, position);
    m_json.key("groundPower");
    m_json.beginObject(Layout::row);
    auto port = element.ports.begin();
    for (const std::string_view name : names)
      member(name, element.isDetermined ? std::optional(port++->power) : std::nullopt);
    m_json.endObject();
  }

  void jointPowers() {
    m_json.beginObject();
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      m_json.key(std::to_string(m_mechanism.jointLabel(joint)));
      m_json.beginObject(Layout::row);
      const ElementPower& element = m_report.flow->of(ElementPower::Kind::joint, joint);
      member("fed", element.isDetermined ? std::optional(element.fed()) : std::nullopt);
      groundPower(ElementPower::Kind::joint, joint, {"tail", "head"});
      m_json.endObject();
    }
    m_json.endObject();
  }

  void bearings() {
    m_json.beginArray();
    for (std::size_t joint = 0; joint < m_report.forces.bearings.size(); ++joint) {
      const BearingReaction& bearing = m_report.forces.bearings[joint];
      m_json.beginObject(Layout::row);
      m_json.member("joint", m_mechanism.jointLabel(static_cast<int>(joint)));
      vector("point", bearing.point);
      if (bearing.isDetermined) {
        vector("force", bearing.force);
        vector("moment", bearing.moment);
      } else {
        null("force");
        null("moment");
      }
      m_json.member("determinate", bearing.isDetermined);
      m_json.endObject();
    }
    m_json.endArray();
  }

  void selfStresses() {
    m_json.beginArray();
    for (const auto& members : m_report.lossless.selfStresses) {
      m_json.beginObject(Layout::row);
      for (const auto& [unknown, weight] : members) m_json.member(nameOf(unknown), weight.toString());
      m_json.endObject();
    }
    m_json.endArray();
  }

  /// A mesh by its label, a coupling by its id, a balance as on the command line.
  [[nodiscard]] std::string nameOf(int unknown) const {
    if (unknown < m_model.c()) return std::to_string(m_mechanism.meshLabel(unknown));
    const HeldPart& part = m_report.held[static_cast<std::size_t>(unknown - m_model.c())];
    if (part.coupling >= 0) {
      const std::string id = m_mechanism.couplings[part.coupling].id.text();
      return part.isMain ? id : id + "@" + axisId(part.axis);
    }
    const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(part.balance)];
    if (place.inJoint()) return "joint:" + std::to_string(m_mechanism.jointLabel(place.joint));
    return "link:" + std::to_string(m_mechanism.linkLabel(place.link)) + "@" + axisId(place.axis);
  }

  void power() {
    const PowerSums& sums = *m_report.sums;
    m_json.beginObject(Layout::row);
    member("input", sums.fed);
    member("output", sums.taken);
    member("loss", sums.lost);
    member("latentRatio", m_report.latentRatio);
    m_json.key("circulations");
    if (m_report.circulations) {
      m_json.beginArray();
      for (const Circulation& each : *m_report.circulations) writeCirculation(each);
      m_json.endArray();
    } else {
      m_json.null();
    }
    m_json.endObject();
  }

  void writeCirculation(const Circulation& circulation) {
    m_json.beginObject(Layout::row);
    member("power", circulation.power);
    labels("links", circulation.links, &Mechanism::linkLabel);
    labels("meshes", circulation.meshes, &Mechanism::meshLabel);
    m_json.endObject();
  }

  void efficiency() {
    const bool isSolved = m_report.lossy->outcome == LossySolution::Outcome::solved;
    m_json.beginObject();
    writeEfficiency(isSolved ? m_report.sums : std::nullopt, m_report.efficiency);
    m_json.key("drivers");
    m_json.beginObject(Layout::row);
    for (std::size_t mesh = 0; isSolved && mesh < m_report.lossy->losses.size(); ++mesh) {
      const MeshLoss::Driver driver = m_report.lossy->losses[mesh].driver;
      if (driver == MeshLoss::Driver::none) continue;
      m_json.member(std::to_string(m_mechanism.meshLabel(static_cast<int>(mesh))),
                    std::string_view(driver == MeshLoss::Driver::tail ? "tail" : "head"));
    }
    m_json.endObject();
    m_json.member("selfLocking", m_report.lossy->outcome == LossySolution::Outcome::selfLocking);
    m_json.key("backward");
    if (m_report.backward) {
      m_json.beginObject(Layout::row);
      writeEfficiency(m_report.backwardSums, m_report.backwardEfficiency);
      m_json.member("selfLocking", m_report.backward->outcome == LossySolution::Outcome::selfLocking);
      m_json.endObject();
    } else {
      m_json.null();
    }
    m_json.endObject();
  }

  void writeEfficiency(const std::optional<PowerSums>& sums,
                       const std::optional<RationalFunction>& symbolic) {
    const auto value = sums ? sums->efficiency() : std::nullopt;
    member("value", value);
    m_json.key("numeric");
    value ? m_json.numberOrNull(value->number()) : m_json.null();
    m_json.key("symbolic");
    symbolic ? m_json.string(symbolic->toText()) : m_json.null();
  }

  void matrix() {
    writeTorqueMatrixJson(m_json, m_mechanism, m_report.balancedJoints, *m_report.matrix, m_report.symbolic);
  }
  void ttMatrix() {
    writeTorqueMatrixJson(m_json, m_mechanism, m_report.balancedJoints, *m_report.ttMatrix,
                          m_report.ttSymbolic);
  }

  void agreement() {
    m_json.beginObject(Layout::row);
    m_json.member("equal", m_report.agreement->equal);
    member("largestDifference", m_report.agreement->largestDifference);
    m_json.endObject();
  }

  JsonWriter& m_json;
  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const StaticsReport& m_report;
  const StaticsSolution& m_solution;
  bool m_isAnswered;
  PositionIndex<LinkTag> m_links{m_mechanism.links};
  PositionIndex<JointTag> m_joints{m_mechanism.turningJoints};
};

}  // namespace

void writeStaticsJson(JsonWriter& json, const AnalysisSnapshot* snapshot, const StaticsReport* report,
                      int state, const Diagnostics& diagnostics) {
  json.beginObject();
  json.member("format", "geargraph-statics");
  json.member("version", 1);
  json.key("state");
  if (snapshot != nullptr && state >= 0) {
    json.string(snapshot->mechanism->states[static_cast<std::size_t>(state)].name);
  } else {
    json.null();
  }
  if (report != nullptr) {
    StaticsJson(json, *snapshot, *report).write();
  } else {
    for (const char* name : {"engaged", "share", "speeds", "counts", "loads", "balances", "jointTorques",
                             "couplings", "meshes", "bearings", "selfStresses", "power", "jointPowers",
                             "efficiency", "solution", "ttSolution", "agreement"}) {
      json.key(name);
      json.null();
    }
  }
  json.key("diagnostics");
  writeDiagnostics(json, diagnostics);
  json.endObject();
}

}  // namespace geargraph
