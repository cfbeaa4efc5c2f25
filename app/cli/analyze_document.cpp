#include "app/cli/analyze_document.h"

#include <iostream>
#include <memory>

#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {

std::variant<SnapshotPtr, int> analyzeAndReport(Mechanism mechanism, const Arguments& arguments) {
  SnapshotPtr snapshot =
      analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)), 0, arguments.stop);
  if (!snapshot) return outOfTime(arguments, translated("the analysis"));
  std::cerr << diagnosticLines(arguments.files.front(), snapshot->diagnostics);
  return snapshot;
}

std::variant<SnapshotPtr, int> analyzeEngaged(const Command& command, const Arguments& arguments) {
  auto document = loadEngaged(command, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  return analyzeAndReport(std::get<Mechanism>(std::move(document)), arguments);
}

}  // namespace geargraph::cli
