// `vibration FILE ...`: the frequencies of shafts, meshes and planets.

#include <array>
#include <cmath>
#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/number_options.h"
#include "core/presentation/result_json/vibration_report.h"

namespace geargraph::cli {
namespace {

constexpr double kMaxRpm = 1e9;

/// The whole number of an option, or `otherwise`.
std::variant<int, UsageError> wholeWithin(const Arguments& arguments, std::string_view option, int otherwise,
                                          int least, int most) {
  const auto number = numberWithin(arguments, option, otherwise, least, most);
  if (const auto* error = std::get_if<UsageError>(&number)) return *error;
  const double value = std::get<double>(number);
  if (value != std::floor(value)) return UsageError{translated("%1 is a whole number.", {option})};
  return static_cast<int>(value);
}

std::variant<VibrationOptions, UsageError> vibrationOptions(const Mechanism& mechanism,
                                                            const Arguments& arguments) {
  VibrationOptions options;
  const auto read = [&](std::string_view option, int& into, int least, int most) {
    const auto number = wholeWithin(arguments, option, into, least, most);
    if (const auto* error = std::get_if<UsageError>(&number)) return std::optional(*error);
    into = std::get<int>(number);
    return std::optional<UsageError>();
  };
  using Bounds = FrequencyOptions;
  if (auto error = read("--harmonics", options.lines.harmonics, 1, Bounds::kMaxHarmonics)) return *error;
  if (auto error = read("--sidebands", options.lines.sidebands, 0, Bounds::kMaxSidebands)) return *error;
  if (auto error = read("--planets", options.lines.planets, 1, Bounds::kMaxPlanets)) return *error;
  if (arguments.has("--rpm")) {
    const auto rpm = numberWithin(arguments, "--rpm", 0, 0, kMaxRpm);
    if (const auto* error = std::get_if<UsageError>(&rpm)) return *error;
    if (std::get<double>(rpm) == 0) return UsageError{translated("--rpm is above 0.")};
    options.rpm = std::get<double>(rpm);
  }
  if (const auto word = arguments.value("--input")) {
    if (const auto joint = jointNamed(mechanism, *word)) {
      options.reference = *joint;
    } else if (const auto link = linkNamed(mechanism, *word); link && *link != 0) {
      options.reference = *link;
    } else {
      return UsageError{
          translated("--input is the label of a joint or of a moving link, not \"%1\".", {*word})};
    }
  }
  return options;
}

/// A case under its title.
std::string caseText(const Mechanism& mechanism, const FrequencyCase& of, const VibrationOptions& options) {
  std::string title = titleOf(mechanism);
  if (of.state)
    title = translated("%1, state %2", {title, mechanism.states[static_cast<std::size_t>(*of.state)].name});
  if (of.absence != FrequencyAbsence::none) return title + "\n  " + absenceText(mechanism, of) + '\n';
  title += ", " + referenceText(mechanism, *of.reference);
  if (options.rpm) title += ", " + readableNumber(*options.rpm) + " rpm";
  FrequencyCase alone = of;
  alone.state.reset();
  const ValueTable table = frequencyTable(mechanism, {alone}, options);
  TextRows rows(1);
  for (const ForceColumn& column : table.columns)
    rows[0].push_back(column.unit.empty() ? column.head : column.unit);
  for (const ForceRow& row : table.rows) {
    rows.emplace_back();
    for (const ForceCell& cell : row.cells) rows.back().push_back(cell.text);
  }
  return rows.size() == 1 ? title + '\n' : aligned(title, rows);
}

int runVibration(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kVibration, translated("One file is needed."));
  if (arguments.has("--json") && arguments.has("--csv"))
    return wrongUsage(kVibration, translated("Give --json or --csv."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file, kVibration);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    std::cerr << diagnosticLines(file, document.error());
    return arguments.has("--json") ? print(vibrationJson(nullptr, nullptr, {}), kMechanismErrors)
                                   : kMechanismErrors;
  }
  auto engaged = withEngagementOptions(*std::move(document), arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kVibration, error->message);
  const auto read = vibrationOptions(std::get<Mechanism>(engaged), arguments);
  if (const auto* error = std::get_if<UsageError>(&read)) return wrongUsage(kVibration, error->message);
  const auto& options = std::get<VibrationOptions>(read);
  const auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(engaged)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const auto cases = frequencyCases(*snapshot, options, arguments.stop);
  if (!cases) return outOfTime(arguments, translated("the frequencies"));
  const Mechanism& mechanism = *snapshot->mechanism;
  const int status = hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(vibrationJson(&mechanism, &*cases, options), status);
  if (arguments.has("--csv")) {
    TextSink sink;
    writeForceCsv(sink, frequencyTable(mechanism, *cases, options));
    return print(sink.take(), status);
  }
  std::string text;
  for (const FrequencyCase& each : *cases)
    text += (text.empty() ? "" : "\n") + caseText(mechanism, each, options);
  return print(text, status);
}

constexpr std::array kVibrationOptions = {
    Option{"--rpm", "1500", toTranslate("the speed of the input shaft: frequencies also in Hz")},
    Option{"--input", "8",
           toTranslate("the joint or link (by label) that ratios are of, instead of the first input or the "
                       "state's drive")},
    Option{"--harmonics", "3", toTranslate("multiples of each tooth mesh (1)")},
    Option{"--sidebands", "2", toTranslate("on each side of each multiple (1)")},
    Option{"--planets", "3", toTranslate("how many planets one stands for that is drawn alone (1)")},
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
    Option{"--csv", "", toTranslate("as CSV")},
};

}  // namespace

const Command kVibration = {
    "vibration",
    "FILE [--rpm 1500] [--input 8] [--harmonics N] [--sidebands N] [--planets N] [--state NAME | --engage "
    "A,B] "
    "[--json | --csv]",
    toTranslate("The frequencies of shafts, tooth meshes and planets, as ratios to the input shaft."),
    kVibrationOptions, runVibration};

}  // namespace geargraph::cli
