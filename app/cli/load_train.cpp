#include "app/cli/load_train.h"

#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/presentation/train_stage/train_stage.h"

namespace geargraph::cli {

std::variant<ExportTrain, int> loadTrain(const Arguments& arguments, const AdaptDocument& adapt) {
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  if (adapt) {
    auto adapted = adapt(std::get<Mechanism>(std::move(document)));
    if (const auto* error = std::get_if<UsageError>(&adapted)) return wrongUsage(kExport, error->message);
    document = std::get<Mechanism>(std::move(adapted));
  }
  const int links = std::get<Mechanism>(document).n();
  if (links > kMaxStageLinks && !arguments.has("--gear") && !arguments.has("--link")) {
    std::cerr << "geargraph-cli: "
              << translated(
                     "A train of %1 links has no 3D, which is made of up to %2 links; --gear and --link "
                     "export a part of it. Nothing was written.",
                     {std::to_string(links), std::to_string(kMaxStageLinks)})
              << '\n';
    return static_cast<int>(kResourceLimit);
  }
  const auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(document)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  auto made = exportTrain(snapshot, arguments.stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return exportFailure(arguments, *why);
  auto& loaded = std::get<ExportTrain>(made);
  std::cerr << diagnosticLines(file, loaded.diagnostics);
  if (loaded.train.hasSimpleBodies) {
    std::cerr
        << "geargraph-cli: "
        << translated(
               "A train of %1 gears (over %2): wheels are plain discs, shafts and arms are straight and "
               "pass through other parts.",
               {std::to_string(loaded.train.gears.size()), std::to_string(kMaxRoutedGears)})
        << '\n';
  }
  return std::move(loaded);
}

int exportFailure(const Arguments& arguments, const ExportFailure& why) {
  using Kind = ExportFailure::Kind;
  if (why.kind == Kind::stopped) return outOfTime(arguments, why.message);
  if (why.kind == Kind::choice) return wrongUsage(kExport, why.message + ".");
  std::cerr << diagnosticLines(arguments.files.front(), why.diagnostics);
  if (why.kind == Kind::mechanism && !why.message.empty())
    std::cerr << "geargraph-cli: " << translated("%1; nothing was written.", {why.message}) << '\n';
  if (why.kind == Kind::triangles)
    std::cerr << "geargraph-cli: " << translated("%1; choose a coarser --tolerance.", {why.message}) << '\n';
  if (why.kind == Kind::limit) std::cerr << "geargraph-cli: " << why.message << ".\n";
  return why.kind == Kind::mechanism ? kMechanismErrors : kResourceLimit;
}

}  // namespace geargraph::cli
