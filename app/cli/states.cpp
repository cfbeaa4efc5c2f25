// `states FILE ...`: the shift table of a gearbox, with the torques of its couplings.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/statics_options.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/quantity.h"
#include "core/presentation/result_json/states_json.h"
#include "core/teaching/derivation/solved_statics.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/load_diagnostics.h"

namespace geargraph::cli {
namespace {

std::string ratioText(const Rational& value) {
  constexpr double kMaxPlain = 1e15;  // larger ones are written with an exponent
  const double number = value.toDouble();
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, std::abs(number) < kMaxPlain ? "%.4f" : "%.10g", number);
  return buffer;
}

/// The shift table: a row a state, cells as text.
std::vector<std::vector<std::string>> shiftTableOf(const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  std::vector<std::vector<std::string>> rows{{translated("state")}};
  for (const ShiftElement& coupling : mechanism.couplings) rows[0].push_back(coupling.id.text());
  for (const char* heading :
       {toTranslate("ratio"), toTranslate("decimal"), toTranslate("step"), toTranslate("in the gear ratios")})
    rows[0].push_back(translated(heading));
  const StateSolution* before = nullptr;
  for (const StateSolution& solution : *snapshot.states) {
    std::vector<std::string> row{mechanism.states[static_cast<std::size_t>(solution.state)].name};
    for (int coupling = 0; coupling < static_cast<int>(mechanism.couplings.size()); ++coupling) {
      const bool isEngaged = std::binary_search(solution.engaged.begin(), solution.engaged.end(), coupling);
      row.emplace_back(isEngaged ? "x" : ".");
    }
    const auto step = before == nullptr ? std::nullopt : stepBetween(*before, solution);
    row.push_back(solution.ratio ? readableNumber(*solution.ratio) : "-");
    row.push_back(solution.ratio ? ratioText(*solution.ratio) : "-");
    row.push_back(step ? ratioText(*step) : "");
    row.push_back(solution.symbolicRatio ? solution.symbolicRatio->toText() : "");
    rows.push_back(std::move(row));
    before = &solution;
  }
  return rows;
}

std::size_t widthOf(const std::string& utf8) {
  return static_cast<std::size_t>(std::count_if(
      utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

/// The names at the left, numbers at the right edge of their columns, the symbols last.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - widthOf(row[i]), ' ');
      const bool isLeft = i == 0 || i + 1 == row.size();
      line += (i == 0 ? "" : "  ") + (isLeft ? row[i] + gap : gap + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

/// Why a state without a ratio has none, where no diagnostic says it.
std::string remarks(const AnalysisSnapshot& snapshot) {
  std::string text;
  for (const StateSolution& solution : *snapshot.states) {
    const ShiftState& state = snapshot.mechanism->states[static_cast<std::size_t>(solution.state)];
    const bool isExplained = std::any_of(solution.diagnostics.begin(), solution.diagnostics.end(),
                                         [](const Diagnostic& each) { return each.code != Code::stateIdle; });
    if (solution.ratio || isExplained) continue;
    if (!state.drive || !state.driven) {
      text += translated("State %1: it names no drive and driven link, so it has no ratio.", {state.name});
    } else {
      text +=
          solution.isDrivenAtRest
              ? translated("State %1: the driven link does not move.", {state.name})
              : translated("State %1: the driven link turns about several directions at once.", {state.name});
    }
    text += '\n';
  }
  return text.empty() ? text : '\n' + text;
}

/// The torques at the ends of the states and of their couplings, and the efficiencies: a row a state.
std::string torquesText(const Mechanism& mechanism, const std::vector<StateForces>& states) {
  const ForceTable table = shiftTable(mechanism, states);
  const std::size_t couplings = mechanism.couplings.size();
  const auto cellOf = [&](std::size_t row, ShiftColumn column) {
    return table.rows[row].cells[1 + couplings + static_cast<std::size_t>(column)].text;
  };
  TextRows rows{{translated("state"), translated("drive"), translated("driven")}};
  for (const ShiftElement& coupling : mechanism.couplings) rows[0].push_back(coupling.id.text());
  rows[0].push_back(translated("efficiency"));
  rows[0].push_back(translated("backward"));
  for (std::size_t state = 0; state < states.size(); ++state) {
    const StaticsReport* const report = states[state].report ? &*states[state].report : nullptr;
    const auto ends =
        report != nullptr && report->isAnswered() ? endTorques(mechanism, *report) : std::nullopt;
    std::vector<std::string> row{mechanism.states[state].name,
                                 ends ? readableNumber(ends->drive.number()) : "-",
                                 ends ? readableNumber(ends->driven.number()) : "-"};
    for (std::size_t coupling = 0; coupling < couplings; ++coupling)
      row.push_back(table.rows[state].cells[1 + coupling].text);
    row.push_back(cellOf(state, ShiftColumn::efficiency));
    row.push_back(cellOf(state, ShiftColumn::backward));
    rows.push_back(std::move(row));
  }
  return aligned(translated("Torques in N m"), rows) + (table.note.empty() ? "" : table.note + '\n');
}

std::string asText(const AnalysisSnapshot& snapshot, const std::vector<StateForces>& torques) {
  const std::string name = titleOf(*snapshot.mechanism);
  const std::size_t count = snapshot.mechanism->states.size();
  if (count == 0) return translated("%1: no states", {name}) + '\n';
  std::string text = (count == 1 ? translated("%1: 1 state", {name})
                                 : translated("%1: %2 states", {name, std::to_string(count)})) +
                     "\n\n";
  return text + alignedTable(shiftTableOf(snapshot)) + remarks(snapshot) + '\n' +
         torquesText(*snapshot.mechanism, torques);
}

/// The errors and warnings about the torques, beside those of the document.
Diagnostics torqueDiagnostics(const Mechanism& mechanism, const std::vector<StateForces>& torques) {
  std::vector<const StaticsReport*> reports;
  for (const StateForces& each : torques) reports.push_back(each.report ? &*each.report : nullptr);
  return solvedLoadDiagnostics(mechanism, reports);
}

/// With the torque at the drive and the sharing of the call instead of the document's.
std::variant<Mechanism, UsageError> withTorqueOptions(Mechanism mechanism, const StaticsOptions& options,
                                                      const Arguments& arguments) {
  if (options.sharing) mechanism.sharing = options.sharing;
  const auto word = arguments.value("--torque");
  if (!word) return mechanism;
  const auto torque = withUnitFromText(*word, Quantity::torque);
  if (!torque) return UsageError{translated("--torque is a torque like 100Nm, not \"%1\".", {*word})};
  Expected<Mechanism> next = withDriveTorque(std::move(mechanism), *torque);
  if (!next) return UsageError{next.error().front().message};
  return *std::move(next);
}

int runStates(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kStates, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto document = std::get<Expected<Mechanism>>(loaded);
  StaticsOptions options;
  if (const auto error = readLossOptions(arguments, options)) return wrongUsage(kStates, error->message);
  SnapshotPtr snapshot;
  std::vector<StateForces> torques;
  if (document) {
    auto mechanism = withTorqueOptions(*std::move(document), options, arguments);
    if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kStates, error->message);
    snapshot = analyzeLive(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(mechanism))), 0,
                           arguments.stop);
    if (snapshot) snapshot = analyzeStates(snapshot, {}, arguments.stop);
    if (!snapshot) return outOfTime(arguments, translated("the shift table"));
    auto shift = solvedShift(snapshot, options.efficiency, arguments.stop);
    if (!shift) return outOfTime(arguments, translated("the torques"));
    torques = std::move(*shift);
  }
  Diagnostics diagnostics = snapshot ? snapshot->diagnostics : document.error();
  if (snapshot) append(diagnostics, torqueDiagnostics(*snapshot->mechanism, torques));
  std::cerr << diagnosticLines(file, diagnostics);
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(statesJson(snapshot.get(), torques), status);
  const bool isThere = snapshot && (snapshot->states || snapshot->mechanism->states.empty());
  return isThere ? print(asText(*snapshot, torques), status) : status;
}

constexpr std::array kStatesOptions = {
    Option{"--torque", "100Nm", toTranslate("at the drive of every state, instead of the document's")},
    Option{"--eta", "0.98", toTranslate("efficiency of meshes that state none")},
    kShareOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kStates = {"states", "FILE [--torque 100Nm] [--eta 0.98] [--json]",
                         toTranslate("The shift table: what each state of the brakes and clutches does."),
                         kStatesOptions, runStates};

}  // namespace geargraph::cli
