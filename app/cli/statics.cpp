// `statics FILE ...`: torques, forces, powers and efficiency, for people or as JSON.

#include <array>
#include <iostream>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/statics_options.h"
#include "app/cli/statics_text.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/input_options.h"
#include "core/presentation/result_json/statics_json.h"

namespace geargraph::cli {
namespace {

/// What one call solves: a document, and one report a state.
struct Solved {
  SnapshotPtr snapshot;
  StaticsOptions options;
  std::vector<int> states;                            ///< positions; -1: none
  std::vector<std::optional<StaticsReport>> reports;  ///< none where the mechanism has errors
};

/// The diagnostics of the document that concern a state: its inputs do not.
Diagnostics documentDiagnostics(const AnalysisSnapshot& snapshot, int state) {
  Diagnostics all;
  for (const Diagnostic& diagnostic : snapshot.diagnostics) {
    const bool isIdle = state >= 0 && diagnostic.code == Code::invalidInputs;
    if (!isIdle) all.push_back(diagnostic);
  }
  return all;
}

/// These, and those of its statics.
Diagnostics allDiagnostics(const Solved& solved, std::size_t place) {
  Diagnostics all = documentDiagnostics(*solved.snapshot, solved.states[place]);
  if (const auto& report = solved.reports[place]) append(all, report->diagnostics);
  return all;
}

std::string asJson(const Solved& solved, bool asList) {
  TextSink sink;
  {
    JsonWriter json(sink);
    if (asList) {
      json.beginObject();
      json.member("format", "geargraph-statics");
      json.member("version", 1);
      json.key("states");
      json.beginArray();
    }
    for (std::size_t i = 0; i < solved.states.size(); ++i) {
      const StaticsReport* const report = solved.reports[i] ? &*solved.reports[i] : nullptr;
      writeStaticsJson(json, solved.snapshot.get(), report, solved.states[i], allDiagnostics(solved, i));
    }
    if (asList) {
      json.endArray();
      json.endObject();
    }
  }
  return sink.take();
}

/// The error of a file that is no document.
std::string asJson(const Diagnostics& diagnostics) {
  TextSink sink;
  {
    JsonWriter json(sink);
    writeStaticsJson(json, nullptr, nullptr, -1, diagnostics);
  }
  return sink.take();
}

int solveAll(Solved& solved, const Arguments& arguments) {
  const AnalysisSnapshot& snapshot = *solved.snapshot;
  for (const int state : solved.states) {
    if (snapshot.matroid() == nullptr || hasErrors(documentDiagnostics(snapshot, state))) {
      solved.reports.emplace_back();
      continue;
    }
    StaticsOptions options = solved.options;
    options.state = state;
    auto report =
        analyzeStatics(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                       *snapshot.kinematics->ttGraph, *snapshot.matroid(), options, arguments.stop);
    if (!report) return outOfTime(arguments, translated("the torques"));
    solved.reports.push_back(std::move(*report));
  }
  return kFine;
}

/// A state brings its own couplings: the document's are released, so that its own analysis is of the train.
std::variant<Mechanism, UsageError> engagedForStatics(Mechanism mechanism, const Arguments& arguments) {
  if (!arguments.has("--state") && !arguments.has("--all-states"))
    return withEngagementOptions(std::move(mechanism), arguments);
  if (arguments.has("--engage"))
    return UsageError{translated("Give --state NAME, --all-states or --engage A,B.")};
  mechanism.engaged.clear();
  return mechanism;
}

int runStatics(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kStatics, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file, kStatics);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  const auto& document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    std::cerr << diagnosticLines(file, document.error());
    return arguments.has("--json") ? print(asJson(document.error()), kMechanismErrors) : kMechanismErrors;
  }
  auto engaged = engagedForStatics(*document, arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kStatics, error->message);
  auto mechanism = withInputOptions(std::get<Mechanism>(std::move(engaged)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kStatics, error->message);
  Solved solved;
  auto options = staticsOptions(std::get<Mechanism>(mechanism), arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kStatics, error->message);
  solved.options = std::get<StaticsOptions>(std::move(options));
  auto states = statesAsked(std::get<Mechanism>(mechanism), arguments);
  if (const auto* error = std::get_if<UsageError>(&states)) return wrongUsage(kStatics, error->message);
  solved.states = std::get<std::vector<int>>(std::move(states));
  solved.snapshot = analyzeLive(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(mechanism))),
                                0, arguments.stop);
  if (!solved.snapshot) return outOfTime(arguments, translated("the analysis"));
  if (const int status = solveAll(solved, arguments); status != kFine) return status;
  const bool hasNoStates = solved.states.empty();  // with --all-states
  bool isWrong = hasNoStates && hasErrors(solved.snapshot->diagnostics);
  if (hasNoStates) std::cerr << diagnosticLines(file, solved.snapshot->diagnostics);
  for (std::size_t i = 0; i < solved.states.size(); ++i) {
    const Diagnostics diagnostics = allDiagnostics(solved, i);
    isWrong = isWrong || hasErrors(diagnostics);
    std::cerr << diagnosticLines(file, diagnostics);
  }
  const int status = isWrong ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(asJson(solved, arguments.has("--all-states")), status);
  std::string text;
  if (hasNoStates) text = translated("%1: no states", {titleOf(*solved.snapshot->mechanism)}) + '\n';
  for (std::size_t i = 0; i < solved.reports.size(); ++i) {
    if (!solved.reports[i]) continue;
    text += (text.empty() ? "" : "\n") + staticsText(*solved.snapshot, *solved.reports[i], solved.states[i]);
  }
  return print(text, status);
}

constexpr std::array kStaticsOptions = {
    kStateOption,
    Option{"--all-states", "", toTranslate("of every state")},
    kEngageOption,
    Option{"--load", "PLACE=SIZE",
           toTranslate("joint:14=10Nm, link:3@e=10Nm or link:3=10,-20,-50N@30,-60,130, added")},
    Option{"--no-loads", "", toTranslate("without the loads of the document")},
    Option{"--balance", "PLACE",
           toTranslate("joint:8 or link:7@a: find the torque there; may be given again")},
    Option{"--inputs", "8,9,11", toTranslate("drive these joints (by label) instead of the document's")},
    Option{"--speed", "8=1/2", toTranslate("the speed of an input in rad/s; may be given again")},
    Option{"--efficiency", "", toTranslate("with the losses of the meshes")},
    Option{"--eta", "0.98", toTranslate("efficiency of meshes that state none; implies --efficiency")},
    kShareOption,
    Option{"--no-symbolic", "", toTranslate("without the solution in gear ratios")},
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kStatics = {"statics",
                          "FILE [--state NAME | --all-states | --engage A,B] [--load joint:14=10Nm ...] "
                          "[--balance joint:8 ...] [--efficiency] "
                          "[--eta 0.98] [--json]",
                          toTranslate("Torques, tooth forces, bearing reactions and efficiency under loads."),
                          kStaticsOptions, runStatics};

}  // namespace geargraph::cli
