#pragma once

#include <functional>
#include <variant>

#include "app/cli/arguments.h"
#include "core/presentation/results/train_export.h"

namespace geargraph::cli {

/// Reads the file and makes its gears. Findings go to standard error. The exit status where there is nothing
/// to export: it could not be read, has errors, is too large, or the
/// time limit was over.
/// `adapt`: applied to the document first; what is wrong with its options is wrong usage of `export`.
using AdaptDocument = std::function<std::variant<Mechanism, UsageError>(Mechanism)>;
[[nodiscard]] std::variant<ExportTrain, int> loadTrain(const Arguments& arguments,
                                                       const AdaptDocument& adapt = {});

/// Reports why nothing was written; the exit status.
int exportFailure(const Arguments& arguments, const ExportFailure& why);

}  // namespace geargraph::cli
