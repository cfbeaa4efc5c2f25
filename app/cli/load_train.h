#pragma once

#include <functional>
#include <variant>

#include "app/cli/arguments.h"
#include "core/presentation/results/train_export.h"

namespace geargraph::cli {

/// A change of the document before the export, by options of `export`.
using AdaptDocument = std::function<std::variant<Mechanism, UsageError>(Mechanism)>;
/// Reads the file and generates its gears; diagnostics go to standard error. `adapt` is applied first; its
/// errors are wrong usage of `export`. Returns the exit status if there is nothing to export: the file could
/// not be read, has errors or is too large, or the time limit was exceeded.
[[nodiscard]] std::variant<ExportTrain, int> loadTrain(const Arguments& arguments,
                                                       const AdaptDocument& adapt = {});

/// Reports why nothing was written; returns the exit status.
int exportFailure(const Arguments& arguments, const ExportFailure& why);

}  // namespace geargraph::cli
