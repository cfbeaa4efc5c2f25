#include "core/teaching/force_tables/efficiency_table.h"

#include "core/teaching/force_tables/spoken_cell.h"

namespace geargraph {
namespace {

ForceCell cellOf(const std::optional<double>& number, bool isLocked = false) {
  if (number) return {shownNumber(*number), number, {}};
  if (!isLocked) return {};
  return spokenCell([] { return translated("locks itself"); });
}

std::string jointName(const Mechanism& mechanism, JointOrdinal joint) {
  return translated("joint %1", {std::to_string(mechanism.jointLabel(joint))});
}

}  // namespace

std::string axisTitle(const Mechanism& mechanism, const EfficiencyCurve& curve) {
  if (curve.axis == CurveAxis::meshEfficiency) return translated("efficiency of every mesh");
  return translated("speed of joint %1 / joint %2", {std::to_string(mechanism.jointLabel(curve.inputs[1])),
                                                     std::to_string(mechanism.jointLabel(curve.inputs[0]))});
}

std::string heldTitle(const Mechanism& mechanism, const StaticsReport& report, int held) {
  const int balance = report.held[static_cast<std::size_t>(held)].balance;
  const TorquePlace& place = report.problem.balances[static_cast<std::size_t>(balance)];
  return place.inJoint() ? jointName(mechanism, place.joint)
                         : translated("link %1", {std::to_string(mechanism.linkLabel(place.link))});
}

ValueTable efficiencyTable(const Mechanism& mechanism, const StaticsReport& report,
                           const EfficiencyCurve& curve) {
  ValueTable table;
  const auto add = [&](const auto& head, const char* unit, const char* meaning) {
    table.columns.push_back(spokenColumn(head, unit, translated(meaning), true));
  };
  add([&] { return axisTitle(mechanism, curve); }, "", toTranslate("What the efficiency is followed over."));
  add([] { return translated("efficiency"); }, "", toTranslate("Power taken over power fed."));
  add([] { return translated("efficiency backward"); }, "",
      toTranslate("The same with every known torque reversed: the output drives."));
  for (const int held : curve.held)
    add([&] { return translated("torque at %1", {heldTitle(mechanism, report, held)}); }, "N m",
        toTranslate("What holds the loads there."));
  for (const EfficiencyPoint& point : curve.points) {
    ForceRow& row = table.rows.emplace_back();
    row.cells = {cellOf(point.at.toDouble()), cellOf(point.forward, point.isLocked),
                 cellOf(point.backward, point.isLockedBackward)};
    for (std::size_t i = 0; i < curve.held.size(); ++i)
      row.cells.push_back(i < point.torques.size() ? cellOf(point.torques[i]) : ForceCell{});
  }
  return table;
}

}  // namespace geargraph
