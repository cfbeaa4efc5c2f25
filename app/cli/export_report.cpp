// `export FILE --to html/latex/md/pdf/handout -o OUT`: the worked derivation, both methods.

#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/exercise_plan.h"
#include "app/cli/export_forms.h"
#include "app/cli/input_options.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/handout/handout.h"
#include "core/presentation/pages/report_pdf.h"
#include "core/presentation/results/handout_train.h"
#include "core/presentation/results/named_drawings.h"
#include "core/presentation/results/scorm_package.h"

namespace geargraph::cli {
namespace {

DisplayList drawn(const char* name, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  return drawingNamed(name)->draw(snapshot, nullptr, stop);
}

ReportDrawings drawingsOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const SheetStyle style;
  return {svgOf(drawn("schematic", snapshot, stop), style), svgOf(drawn("digraph", snapshot, stop), style),
          svgOf(drawn("ttgraph", snapshot, stop), style)};
}

/// Writes what `bytesOf` makes of the analysed file; the exit status.
int exportDerivation(const Arguments& arguments,
                     const std::function<Expected<std::string>(const SnapshotPtr&)>& bytesOf) {
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  auto mechanism = withInputOptions(std::get<Mechanism>(std::move(document)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kExport, error->message);
  if (std::get<Mechanism>(mechanism).n() > kMaxReportLinks) {
    std::cerr << "geargraph-cli: "
              << translated(
                     "A derivation of more than %1 links is not written: it would be too long to read. The "
                     "matrices are exported as CSV.",
                     {std::to_string(kMaxReportLinks)})
              << '\n';
    return kResourceLimit;
  }
  const SnapshotPtr snapshot = analyze(
      std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(mechanism))), 0, arguments.stop);
  if (!snapshot) return outOfTime(arguments, translated("the analysis"));
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  const Expected<std::string> bytes = bytesOf(snapshot);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the derivation"));
  if (!bytes) {
    std::cerr << "geargraph-cli: " << bytes.error().front().message << '\n';
    return kResourceLimit;
  }
  const int status = writePicture(*bytes, *arguments.value("-o"));
  if (status != kFine) return status;
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

/// What --exercises and its options ask for; none without it, or the exit status.
std::variant<std::optional<HandoutExercises>, UsageError, int> exercisesFrom(const Arguments& arguments) {
  if (!arguments.has("--exercises")) {
    for (const char* option : {"--kinds", "--seed", "--title", "--variants", "--variant"}) {
      if (arguments.has(option)) return UsageError{translated("%1 needs --exercises.", {option})};
    }
    return std::optional<HandoutExercises>();
  }
  // By its mark a sheet is that of a document as it is in its file.
  for (const char* option : {"--inputs", "--speed", "--state", "--engage"}) {
    if (arguments.has(option))
      return UsageError{
          translated("%1 has no meaning with --exercises, which ask about the document.", {option})};
  }
  if (arguments.files.front() == "-")
    return UsageError{translated("--exercises needs a file, not standard input.")};
  auto plan = planFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&plan)) return *error;
  auto& sheet = std::get<SheetPlan>(plan);
  const auto variant = numberFrom<int>(arguments.value("--variant").value_or("1"));
  if (!variant || *variant < 1 || *variant > sheet.variants)
    return UsageError{translated("--variant is a whole number from 1 to that of --variants.")};
  const auto loaded = loadOrSay(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const auto& mechanism = std::get<Mechanism>(loaded);
  if (mechanism.n() > kMaxExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(mechanism);
  auto kinds = kindsFrom(arguments, source);
  if (const auto* error = std::get_if<UsageError>(&kinds)) return *error;
  sheet.kinds = std::get<std::vector<ExerciseKind>>(std::move(kinds));
  if (sheet.kinds.empty()) return UsageError{translated("Nothing can be asked about this mechanism.")};
  return std::optional(handoutExercises(source, sheet, *variant));
}

}  // namespace

int exportReport(const Arguments& arguments, ReportForm form) {
  return exportDerivation(arguments, [&, form](const SnapshotPtr& snapshot) -> Expected<std::string> {
    return reportText(derivationReport(snapshot), form,
                      [&] { return drawingsOf(*snapshot, arguments.stop); });
  });
}

int exportReportPages(const Arguments& arguments) {
  return exportDerivation(arguments, [&](const SnapshotPtr& snapshot) {
    return reportPdf(derivationReport(snapshot), {drawn("schematic", *snapshot, arguments.stop),
                                                  drawn("digraph", *snapshot, arguments.stop),
                                                  drawn("ttgraph", *snapshot, arguments.stop)});
  });
}

int exportHandout(const Arguments& arguments, HandoutUse use) {
  auto made = exercisesFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&made)) return wrongUsage(kExport, error->message);
  if (const int* status = std::get_if<int>(&made)) return *status;
  const auto& exercises = std::get<std::optional<HandoutExercises>>(made);
  if (exercises && !arguments.has("--seed"))
    std::cerr << translated("--seed %1 asks these questions again.", {std::to_string(exercises->plan.seed)})
              << '\n';
  return exportDerivation(arguments, [&](const SnapshotPtr& document) -> Expected<std::string> {
    const std::string& file = arguments.files.front();
    const bool isVaried = exercises && exercises->plan.variants > 1;
    const SnapshotPtr snapshot = isVaried ? analyze(exercises->mechanism, 0, arguments.stop) : document;
    if (!snapshot) return std::string();  // out of time
    const MadeHandoutTrain train = handoutTrain(
        *snapshot, file == "-" ? "." : std::filesystem::absolute(file).parent_path(), arguments.stop);
    for (const std::string& note : train.notes) std::cerr << file << ": " << note << '\n';
    Expected<std::string> page = handoutHtml(snapshot, drawingsOf(*snapshot, arguments.stop), train.train,
                                             use, exercises, arguments.stop);
    if (!page || use == HandoutUse::alone) return page;
    return scormPackage(reportTitle(*snapshot->mechanism), *page);
  });
}

}  // namespace geargraph::cli
