#include "app/cli/statics_text.h"

#include <vector>

#include "app/cli/engagement_options.h"
#include "app/cli/text_table.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

using Rows = TextRows;

/// "80/27 (2.96296)", "10".
std::string text(const Real& value) {
  if (!value.isExact()) return readableNumber(value.number());
  const std::string exact = value.fraction()->toString();
  if (isLongFraction(exact)) return readableNumber(value.number());
  return value.fraction()->isInteger() ? exact : exact + " (" + readableNumber(value.number()) + ")";
}

std::string text(const Vector3& vector) {
  return "(" + readableNumber(vector[0]) + ", " + readableNumber(vector[1]) + ", " +
         readableNumber(vector[2]) + ")";
}

class StaticsText {
 public:
  StaticsText(const AnalysisSnapshot& snapshot, const StaticsReport& report)
      : m_mechanism(*snapshot.mechanism),
        m_model(*snapshot.kinematics->model),
        m_report(report),
        m_solution(report.solution()) {}

  std::string held() const {
    Rows rows{{"", translated("torque, N m"), translated("power, W")}};
    for (std::size_t part = 0; part < m_report.held.size(); ++part) {
      const int unknown = m_model.c() + static_cast<int>(part);
      const bool isKnown = m_solution.isDetermined(unknown);
      rows.push_back(
          {nameOf(m_report.held[part]),
           isKnown ? text(m_solution.values[static_cast<std::size_t>(unknown)]) : translated("shared"),
           m_report.motion && isKnown ? text(m_report.powers.held[part]) : ""});
    }
    return aligned(translated("Balances and couplings"), rows);
  }

  std::string meshes() const {
    Rows rows{{translated("mesh"), translated("torque on tail, N m"), translated("on head, N m"), "F, N",
               translated("force on head, N"), translated("power, W")}};
    const std::span<const MeshLoss> losses = m_report.losses();
    for (int mesh = 0; mesh < m_model.c(); ++mesh) {
      const auto at = static_cast<std::size_t>(mesh);
      std::vector<std::string> cells{std::to_string(m_mechanism.meshLabel(mesh))};
      if (!m_solution.isDetermined(mesh)) {
        cells.push_back(translated("shared"));
      } else {
        const PortTorques ports = portTorques(m_model, m_solution, losses, mesh);
        cells.push_back(text(ports.tail));
        cells.push_back(text(ports.head));
        const bool hasForces = !m_report.forces.meshes.empty();
        cells.push_back(hasForces ? readableNumber(m_report.forces.meshes[at].tangential) : "");
        cells.push_back(hasForces ? text(m_report.forces.meshes[at].force) : "");
        cells.push_back(m_report.motion ? text(m_report.powers.mesh[at]) : "");
      }
      rows.push_back(std::move(cells));
    }
    return aligned(translated("Meshes (torques about the axes from the carrier)"), rows);
  }

  std::string bearings() const {
    Rows rows{{translated("joint"), translated("force, N"), translated("moment, N m"), translated("at")}};
    for (std::size_t joint = 0; joint < m_report.forces.bearings.size(); ++joint) {
      const BearingReaction& bearing = m_report.forces.bearings[joint];
      rows.push_back({std::to_string(m_mechanism.jointLabel(static_cast<int>(joint))),
                      bearing.isDetermined ? text(bearing.force) : translated("shared"),
                      bearing.isDetermined ? text(bearing.moment) : "", text(bearing.point)});
    }
    return aligned(translated("Bearings (tail on head, base frame)"), rows);
  }

  std::string power() const {
    if (!m_report.sums) return {};
    const PowerSums& sums = *m_report.sums;
    std::string line = translated("Power fed %1 W, taken %2 W, lost %3 W",
                                  {text(sums.fed), text(sums.taken), text(sums.lost)}) +
                       '\n';
    if (m_report.latentRatio)
      line += translated("Passed by the meshes, seen from their carriers, over the power fed: %1",
                         {text(*m_report.latentRatio)}) +
              '\n';
    if (!m_report.lossy) return line;
    if (m_report.lossy->outcome == LossySolution::Outcome::solved) {
      if (const auto efficiency = sums.efficiency())
        line += translated("Efficiency %1", {text(*efficiency)}) + '\n';
    }
    if (m_report.backward) {
      const auto backward = m_report.backwardSums ? m_report.backwardSums->efficiency() : std::nullopt;
      if (backward) line += translated("Efficiency backward %1", {text(*backward)}) + '\n';
      if (m_report.backward->outcome == LossySolution::Outcome::selfLocking)
        line += translated("The output cannot drive it back: it locks itself.") + '\n';
    }
    return line;
  }

  std::string agreement() const {
    if (!m_report.agreement) return {};
    return (m_report.agreement->equal ? translated("Both methods agree.")
                                      : translated("The methods do NOT agree.")) +
           '\n';
  }

 private:
  [[nodiscard]] std::string nameOf(const HeldPart& part) const {
    if (part.coupling >= 0) {
      const ShiftElement& coupling = m_mechanism.couplings[static_cast<std::size_t>(part.coupling)];
      const std::string name = couplingName(coupling.kind, coupling.id.text());
      return part.isMain ? name : about(name, part.axis);
    }
    const TorquePlace& place = m_report.problem.balances[static_cast<std::size_t>(part.balance)];
    if (place.inJoint()) return translated("joint %1", {std::to_string(m_mechanism.jointLabel(place.joint))});
    return about(translated("link %1", {std::to_string(m_mechanism.linkLabel(place.link))}), place.axis);
  }
  [[nodiscard]] std::string about(const std::string& element, int axis) const {
    return translated("%1 about %2", {element, m_mechanism.axes[static_cast<std::size_t>(axis)].id.text()});
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const StaticsReport& m_report;
  const StaticsSolution& m_solution;
};

}  // namespace

std::string staticsText(const AnalysisSnapshot& snapshot, const StaticsReport& report, int state) {
  const Mechanism& mechanism = *snapshot.mechanism;
  std::string heading = titleOf(mechanism);
  if (state >= 0)
    heading = translated("%1, state %2", {heading, mechanism.states[static_cast<std::size_t>(state)].name});
  heading += '\n';
  if (!report.isSolved || !report.lossless.isBalanced())
    return heading + translated("There is no equilibrium.") + '\n';
  if (!report.isAnswered()) return heading + translated("With these losses no torques are known.") + '\n';
  const StaticsText parts(snapshot, report);
  std::string result = heading;
  for (const std::string& part :
       {parts.held(), parts.meshes(), parts.bearings(), parts.power(), parts.agreement()}) {
    if (!part.empty()) result += '\n' + part;
  }
  return result;
}

}  // namespace geargraph::cli
