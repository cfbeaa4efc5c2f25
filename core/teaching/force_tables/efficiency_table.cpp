#include "core/teaching/force_tables/efficiency_table.h"

namespace geargraph::inline force_tables {
namespace {

ForceCell cellOf(const std::optional<double>& number, bool isLocked = false) {
  if (number) return {shownNumber(*number), number, {}};
  return {isLocked ? "locks itself" : "", {}, {}};
}

std::string jointName(const Mechanism& mechanism, int joint) {
  return "joint " + std::to_string(mechanism.jointLabel(joint));
}

}  // namespace

std::string axisTitle(const Mechanism& mechanism, const EfficiencyCurve& curve) {
  if (curve.axis == CurveAxis::meshEfficiency) return "efficiency of every mesh";
  return "speed of " + jointName(mechanism, curve.inputs[1]) + " / " + jointName(mechanism, curve.inputs[0]);
}

std::string heldTitle(const Mechanism& mechanism, const StaticsReport& report, int held) {
  const int balance = report.held[static_cast<std::size_t>(held)].balance;
  const TorquePlace& place = report.problem.balances[static_cast<std::size_t>(balance)];
  return place.inJoint() ? jointName(mechanism, place.joint)
                         : "link " + std::to_string(mechanism.linkLabel(place.link));
}

ValueTable efficiencyTable(const Mechanism& mechanism, const StaticsReport& report,
                           const EfficiencyCurve& curve) {
  ValueTable table;
  const auto add = [&](std::string head, std::string unit, std::string meaning) {
    table.columns.push_back({std::move(head), std::move(unit), std::move(meaning), true, false});
  };
  add(axisTitle(mechanism, curve), "", "What the efficiency is followed over.");
  add("efficiency", "", "Power taken over power fed.");
  add("efficiency backward", "", "The same with every known torque reversed: the output drives.");
  for (const int held : curve.held)
    add("torque at " + heldTitle(mechanism, report, held), "N m", "What holds the loads there.");
  for (const EfficiencyPoint& point : curve.points) {
    ForceRow& row = table.rows.emplace_back();
    row.cells = {cellOf(point.at.toDouble()), cellOf(point.forward, point.isLocked),
                 cellOf(point.backward, point.isLockedBackward)};
    for (std::size_t i = 0; i < curve.held.size(); ++i)
      row.cells.push_back(i < point.torques.size() ? cellOf(point.torques[i]) : ForceCell{});
  }
  return table;
}

}  // namespace geargraph::inline force_tables
