// `backlash FILE ...`: lost motion by the play of the teeth.

#include <array>
#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/result_json/lost_motion_report.h"

namespace geargraph::cli {
namespace {

/// A case under its title.
std::string lostMotionText(const Mechanism& mechanism, LostMotionCase of) {
  std::string title = titleOf(mechanism);
  if (of.state)
    title = translated("%1, state %2", {title, mechanism.states[static_cast<std::size_t>(*of.state)].name});
  if (!of.motions)
    return title + "\n  " +
           translated("No lost motion is known: the train has no solution, or is too large.") + '\n';
  of.state.reset();
  const ValueTable table = lostMotionTable(mechanism, {of});
  TextRows rows(1);
  for (const ForceColumn& column : table.columns)
    rows[0].push_back(column.unit.empty() ? column.head : column.head + " [" + column.unit + ']');
  for (const ForceRow& row : table.rows) {
    rows.emplace_back();
    for (const ForceCell& cell : row.cells) rows.back().push_back(cell.text);
  }
  if (rows.size() == 1) return title + "\n  " + translated("No joint follows an input.") + '\n';
  std::string text = aligned(title, rows);
  if (of.motions->isShared)
    text +=
        "  " + translated("Meshes that follow from others share their play; the tightest decides.") + '\n';
  return text;
}

int runBacklash(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kBacklash, translated("One file is needed."));
  if (arguments.has("--json") && arguments.has("--csv"))
    return wrongUsage(kBacklash, translated("Give --json or --csv."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file, kBacklash);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    std::cerr << diagnosticLines(file, document.error());
    return arguments.has("--json") ? print(lostMotionJson(nullptr, {}), kMechanismErrors) : kMechanismErrors;
  }
  auto engaged = withEngagementOptions(*std::move(document), arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kBacklash, error->message);
  const auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(engaged)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const Mechanism& mechanism = *snapshot->mechanism;
  std::optional<std::vector<LostMotionCase>> cases;
  if (mechanism.states.empty() || !mechanism.engaged.empty()) {
    if (auto one = lostMotionCase(*snapshot, arguments.stop))
      cases = std::vector<LostMotionCase>{*std::move(one)};
  } else {
    cases = lostMotionCases(mechanism, arguments.stop);
  }
  if (!cases) return outOfTime(arguments, translated("the lost motion"));
  const int status = hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(lostMotionJson(&mechanism, *cases), status);
  if (arguments.has("--csv")) {
    TextSink sink;
    writeForceCsv(sink, lostMotionTable(mechanism, *cases));
    return print(sink.take(), status);
  }
  std::string text;
  for (const LostMotionCase& each : *cases)
    text += (text.empty() ? "" : "\n") + lostMotionText(mechanism, each);
  return print(text, status);
}

constexpr std::array kBacklashOptions = {
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
    Option{"--csv", "", toTranslate("as CSV")},
};

}  // namespace

const Command kBacklash = {
    "backlash", "FILE [--state NAME | --engage A,B] [--json | --csv]",
    toTranslate("How far outputs turn while inputs are held, by the play of the teeth."), kBacklashOptions,
    runBacklash};

}  // namespace geargraph::cli
