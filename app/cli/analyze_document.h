#pragma once

#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// The live analysis of a mechanism, with its diagnostics on standard error. The exit status if the time
/// limit is over, which it reports.
[[nodiscard]] std::variant<SnapshotPtr, int> analyzeAndReport(Mechanism mechanism,
                                                              const Arguments& arguments);

/// The same for the document that the arguments name, as loadEngaged() reads it.
[[nodiscard]] std::variant<SnapshotPtr, int> analyzeEngaged(const Command& command,
                                                            const Arguments& arguments);

}  // namespace geargraph::cli
