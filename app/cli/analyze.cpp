// `analyze FILE [--inputs 8,9,11] [--speed 8=1 ...] [--json]`: everything that is computed, for people or as
// JSON.

#include <array>
#include <memory>

#include "app/cli/analyze_text.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/input_options.h"
#include "core/presentation/result_json/analysis_json.h"

namespace geargraph::cli {
namespace {

/// The document analysed with the inputs and the engagement of the command line.
std::variant<SnapshotPtr, UsageError> analysed(const Mechanism& document, const Arguments& arguments) {
  auto engaged = withEngagementOptions(document, arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return *error;
  auto mechanism = withInputOptions(std::get<Mechanism>(std::move(engaged)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return *error;
  const SolveOptions options{!arguments.has("--no-symbolic")};
  return analyze(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(mechanism))), 0,
                 arguments.stop, options);
}

int runAnalyze(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kAnalyze, translated("One file is needed."));
  if (arguments.has("--symbolic") && arguments.has("--no-symbolic")) {
    return wrongUsage(kAnalyze, translated("Give --symbolic or --no-symbolic."));
  }
  const std::string& file = arguments.files.front();
  const auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  const auto& document = std::get<Expected<Mechanism>>(loaded);
  SnapshotPtr snapshot;
  if (document) {
    const auto result = analysed(*document, arguments);
    if (const auto* error = std::get_if<UsageError>(&result)) return wrongUsage(kAnalyze, error->message);
    snapshot = std::get<SnapshotPtr>(result);
    if (!snapshot) return outOfTime(arguments, translated("the analysis"));
  }
  const Diagnostics& diagnostics = snapshot ? snapshot->diagnostics : document.error();
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (!arguments.has("--json")) {
    return print((snapshot ? analysisText(snapshot) + (diagnostics.empty() ? "" : "\n") : "") +
                     diagnosticLines(file, diagnostics),
                 status);
  }
  StandardOutput out;
  writeAnalysisJson(out, snapshot, diagnostics, {.dense = arguments.has("--dense")});
  return out.failed() ? fileFailure(translated("Standard output could not be written.")) : status;
}

constexpr std::array kAnalyzeOptions = {
    Option{"--inputs", "8,9,11", toTranslate("drive these joints (by label) instead of the document's")},
    Option{"--speed", "8=1/2", toTranslate("the speed of an input in rad/s; may be repeated")},
    kStateOption,
    kEngageOption,
    Option{"--symbolic", "", toTranslate("with the solution in gear ratios (the default)")},
    Option{"--no-symbolic", "", toTranslate("without it")},
    Option{"--json", "", toTranslate("as JSON")},
    Option{"--dense", "",
           toTranslate("with --json: all entries of matrices, also above 250,000 (else triplets)")},
};

}  // namespace

const Command kAnalyze = {
    "analyze",
    "FILE [--inputs 8,9,11] [--speed 8=1 ...] [--state NAME | --engage A,B] [--no-symbolic] "
    "[--json] [--dense]",
    toTranslate("Analyses a mechanism, for people or as JSON."), kAnalyzeOptions, runAnalyze};

}  // namespace geargraph::cli
