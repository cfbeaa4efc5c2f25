// The torques of a gearbox, a row a state.

#include "core/foundations/base/position_index.h"
#include "core/teaching/force_tables/spoken_cell.h"

namespace geargraph::inline force_tables {
namespace {

ForceCell numberCell(double value) {
  return {shownNumber(value), value, {}};
}

/// With its fraction, where that tells more.
ForceCell realCell(const Real& value) {
  ForceCell cell = numberCell(value.number());
  const std::string exact = shownReal(value);
  if (exact != cell.text && exact.find('/') != std::string::npos) cell.exact = exact;
  return cell;
}

std::size_t placeOf(ShiftColumn column, std::size_t couplings) {
  return 1 + couplings + static_cast<std::size_t>(column);
}

std::vector<ForceColumn> shiftColumns(const Mechanism& mechanism) {
  std::vector<ForceColumn> columns{
      wordedColumn(toTranslate("state"), "", toTranslate("The state of the gearbox, by its name."), false)};
  for (const Coupling& coupling : mechanism.couplings) {
    const bool isBrake = coupling.kind == CouplingKind::brake;
    columns.push_back(
        {coupling.id.text(), "N m",
         isBrake ? translated("The torque that the brake exerts on its link while it is engaged.")
                 : translated("The torque that the clutch exerts on the first of its links while it is "
                              "engaged; the second one has the reaction."),
         true, false});
  }
  const auto add = [&](const char* head, const char* unit, const char* meaning, bool isFraction = false) {
    columns.push_back(wordedColumn(head, unit, meaning, true, isFraction));
  };
  add(toTranslate("exact ratio"), "", toTranslate("The speed of the drive over that of the driven link."),
      true);
  add(toTranslate("ratio"), "", toTranslate("The same as a decimal."));
  add(toTranslate("found"), "N m",
      toTranslate("The torque that holds the loads, mostly at the driven link; the drive gets 1 N m where "
                  "the document has no load there."));
  add(toTranslate("efficiency"), "", toTranslate("Power taken over power fed, with the drive driving."));
  add(toTranslate("backward"), "",
      toTranslate("The same with all known torques reversed: the output drives."));
  add(toTranslate("latent"), "",
      toTranslate("The power that all meshes pass, seen from their carriers, over the power fed."));
  add(toTranslate("circulating"), "",
      toTranslate("The greatest power that goes round in a loop, for each watt that is fed."));
  return columns;
}

ForceCell efficiencyCell(const std::optional<LossySolution>& solution, const std::optional<PowerSums>& sums) {
  if (!solution || solution->outcome == LossySolution::Outcome::undecided) return {};
  if (solution->outcome == LossySolution::Outcome::selfLocking)
    return spokenCell([] { return translated("locks"); });
  const auto value = sums ? sums->efficiency() : std::nullopt;
  return value ? realCell(*value) : ForceCell();
}

void fillRow(const StaticsReport& report, std::size_t couplings, ForceRow& row) {
  const StaticsSolution& solution = report.solution();
  const auto cellOf = [&](ShiftColumn column) -> ForceCell& { return row.cells[placeOf(column, couplings)]; };
  const auto meshes = static_cast<std::size_t>(solution.unknowns) - report.held.size();
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    const HeldPart& held = report.held[part];
    if (held.coupling >= 0 && !held.isMain) continue;
    ForceCell& cell = held.coupling >= 0 ? row.cells[1 + static_cast<std::size_t>(held.coupling)]
                                         : cellOf(ShiftColumn::found);
    const auto unknown = meshes + part;
    cell = solution.determined[unknown] != 0 ? realCell(solution.values[unknown])
                                             : spokenCell([] { return translated("shared"); });
  }
  cellOf(ShiftColumn::efficiency) = efficiencyCell(report.lossy, report.sums);
  cellOf(ShiftColumn::backward) = efficiencyCell(report.backward, report.backwardSums);
  if (report.latentRatio) cellOf(ShiftColumn::latent) = realCell(*report.latentRatio);
  const double fed = report.sums ? report.sums->fed.number() : 0;
  if (!report.circulations || fed <= 0) return;
  cellOf(ShiftColumn::circulating) = report.circulations->empty()
                                         ? numberCell(0)
                                         : realCell(report.circulations->front().power / report.sums->fed);
}

}  // namespace

ForceTable shiftTable(const Mechanism& mechanism, std::span<const StateForces> states) {
  ForceTable table;
  table.kind = ForceTableKind::states;
  table.columns = shiftColumns(mechanism);
  for (const StateForces& each : states) {
    const ShiftState& state = mechanism.states[static_cast<std::size_t>(each.state)];
    ForceRow& row = table.rows.emplace_back();
    for (const auto& end : {state.drive, state.driven})
      if (end) row.elements.emplace_back(*end);
    row.cells.resize(table.columns.size());
    row.cells.front().text = state.name;
    if (!each.report) continue;
    const std::size_t couplings = mechanism.couplings.size();
    if (const auto& ratio = each.report->ratio) {
      row.cells[placeOf(ShiftColumn::exactRatio, couplings)] = {
          shownReal(Real(*ratio)), ratio->toDouble(), {}};
      row.cells[placeOf(ShiftColumn::ratio, couplings)] = realCell(Real(*ratio));
    }
    if (each.report->isSolved && each.report->lossless.isBalanced()) fillRow(*each.report, couplings, row);
  }
  return table;
}

}  // namespace geargraph::inline force_tables
