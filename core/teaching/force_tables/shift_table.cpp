// The torques of a gearbox, a row a state.

#include <algorithm>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/text_lists.h"
#include "core/mechanism/model/load_edits.h"
#include "core/teaching/force_tables/spoken_cell.h"

namespace geargraph {
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
  for (const ShiftElement& coupling : mechanism.couplings) {
    const bool isBrake = coupling.kind == ShiftElementKind::brake;
    columns.push_back(
        {coupling.id.text(), "N m",
         isBrake ? translated("The torque that the brake exerts on its link while it is engaged.")
         : coupling.kind == ShiftElementKind::freewheel
             ? translated(
                   "The torque that the freewheel exerts on the first of its links while it is locked; "
                   "the second one has the reaction.")
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
      toTranslate("The torque that holds the loads: at the driven link, or at the drive where loads on the "
                  "driven link alone are given."));
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

void fillTorques(const StaticsReport& report, std::size_t couplings, ForceRow& row) {
  const StaticsSolution& solution = report.solution();
  const auto meshes = static_cast<std::size_t>(solution.unknowns) - report.held.size();
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    const HeldPart& held = report.held[part];
    if (held.coupling >= 0 && !held.isMain) continue;
    ForceCell& cell = held.coupling >= 0 ? row.cells[1 + static_cast<std::size_t>(held.coupling)]
                                         : row.cells[placeOf(ShiftColumn::found, couplings)];
    const auto unknown = meshes + part;
    cell = solution.determined[unknown] != 0 ? realCell(solution.values[unknown])
                                             : spokenCell([] { return translated("shared"); });
  }
}

void fillEfficiencies(const StaticsReport& report, std::size_t couplings, ForceRow& row) {
  const auto cellOf = [&](ShiftColumn column) -> ForceCell& { return row.cells[placeOf(column, couplings)]; };
  cellOf(ShiftColumn::efficiency) = efficiencyCell(report.lossy, report.sums);
  cellOf(ShiftColumn::backward) = efficiencyCell(report.backward, report.backwardSums);
  if (report.latentRatio) cellOf(ShiftColumn::latent) = realCell(*report.latentRatio);
  const double fed = report.sums ? report.sums->fed.number() : 0;
  if (!report.circulations || fed <= 0) return;
  cellOf(ShiftColumn::circulating) = report.circulations->empty()
                                         ? numberCell(0)
                                         : realCell(report.circulations->front().power / report.sums->fed);
}

/// The places of loads, each once: "link 1 and joint 9".
std::string placesOf(const Mechanism& mechanism, const std::vector<Load>& loads) {
  std::vector<std::string> places;
  for (const Load& load : loads) {
    const auto joint = jointOf(load);
    const std::string place =
        joint ? translated("joint %1", {labelOf(mechanism, *joint).value_or(joint->text())})
              : translated("link %1", {labelOf(mechanism, *linkOf(load)).value_or(linkOf(load)->text())});
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  return listed(places, kAllNames);
}

std::string noteOn(const Mechanism& mechanism, std::span<const StateForces> states) {
  std::vector<Load> others;
  std::vector<Load> leftOut;
  for (const StateForces& each : states) {
    if (!each.report) continue;
    leftOut.insert(leftOut.end(), each.report->leftOut.begin(), each.report->leftOut.end());
    const auto ends = each.report->isAnswered() ? endTorques(mechanism, *each.report) : std::nullopt;
    if (ends) others.insert(others.end(), ends->otherLoads.begin(), ends->otherLoads.end());
  }
  std::string note;
  if (!others.empty()) note = translated("The loads on %1 act as well.", {placesOf(mechanism, others)});
  if (leftOut.empty()) return note;
  if (!note.empty()) note += ' ';
  return note + translated("The torque at the drive takes the place of the loads on %1.",
                           {placesOf(mechanism, leftOut)});
}

std::string linkLabel(const Mechanism& mechanism, const std::optional<LinkId>& link) {
  return link ? labelOf(mechanism, *link).value_or(link->text()) : std::string();
}

std::string namesOf(const std::vector<ShiftElementId>& couplings) {
  std::string names;
  for (const ShiftElementId& each : couplings) names += (names.empty() ? "" : " ") + each.text();
  return names;
}

/// Of the shift table, counted from its end.
std::size_t ratioColumn(const ValueTable& table) {
  return table.columns.size() - static_cast<std::size_t>(ShiftColumn::count) +
         static_cast<std::size_t>(ShiftColumn::ratio);
}

}  // namespace

ValueTable shiftSheet(const Mechanism& mechanism, const ValueTable& shiftTable) {
  ValueTable sheet = shiftTable;
  const std::size_t ratio = ratioColumn(sheet);
  const auto at = [](auto& list, std::size_t position) {
    return list.begin() + static_cast<std::ptrdiff_t>(position);
  };
  sheet.columns.insert(
      at(sheet.columns, ratio + 1),
      wordedColumn(toTranslate("step"), "", toTranslate("The ratio before over this one"), true));
  const ForceColumn ends[] = {
      wordedColumn(toTranslate("drive"), "", toTranslate("The link that drives in the state."), false),
      wordedColumn(toTranslate("driven"), "", toTranslate("The link that is driven in the state."), false),
      wordedColumn(toTranslate("engaged"), "", toTranslate("The brakes and clutches that it engages."),
                   false)};
  sheet.columns.insert(at(sheet.columns, 1), std::begin(ends), std::end(ends));
  std::optional<double> before;
  for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
    std::vector<ForceCell>& cells = sheet.rows[row].cells;
    const std::optional<double> now = cells[ratio].number;
    ForceCell step;
    if (before && now && *before * *now > 0) step = numberCell(*before / *now);
    before = now;
    cells.insert(at(cells, ratio + 1), step);
    const ShiftState& state = mechanism.states[row];
    const ForceCell named[] = {{linkLabel(mechanism, state.drive), std::nullopt, {}},
                               {linkLabel(mechanism, state.driven), std::nullopt, {}},
                               {namesOf(state.engaged), std::nullopt, {}}};
    cells.insert(at(cells, 1), std::begin(named), std::end(named));
  }
  return sheet;
}

std::optional<double> spreadOf(const ValueTable& shiftTable) {
  std::vector<double> ratios;
  for (const ForceRow& row : shiftTable.rows) {
    const std::optional<double> ratio = row.cells[ratioColumn(shiftTable)].number;
    if (ratio && *ratio > 0) ratios.push_back(*ratio);
  }
  if (ratios.size() < 2) return std::nullopt;
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return *most / *least;
}

ForceTable shiftTable(const Mechanism& mechanism, std::span<const StateForces> states) {
  ForceTable table;
  table.kind = ForceTableKind::states;
  table.columns = shiftColumns(mechanism);
  table.note = noteOn(mechanism, states);
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
    if (each.report->isAnswered()) fillTorques(*each.report, couplings, row);
    const StaticsReport& own = each.ofEfficiency();
    if (own.isSolved && own.lossless.isBalanced()) fillEfficiencies(own, couplings, row);
  }
  return table;
}

}  // namespace geargraph
