#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"
#include "core/presentation/meshfile/train_files.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// A document with its gears and how they move.
struct LoadedTrain {
  SnapshotPtr snapshot;  ///< with a tree and its kinematics
  GearTrain train;
  /// Rates of all joints (rad/s): at the document's speeds, and with all inputs at different ones, which
  /// moves meshes that those leave at rest. None where there is nothing to solve.
  std::vector<std::vector<Rational>> motions;

  [[nodiscard]] const Mechanism& mechanism() const { return *snapshot->mechanism; }
  [[nodiscard]] PlacedTrain placed() const {
    return {mechanism(), *snapshot->tree, snapshot->kinematics->placement(), train};
  }
};

/// Reads the file and makes its gears. Findings go to standard error. The exit status where there is nothing
/// to export: it could not be read, has errors, is too large, or the
/// time limit was over.
/// `adapt`: applied to the document first; what is wrong with its options is wrong usage of `export`.
using AdaptDocument = std::function<std::variant<Mechanism, UsageError>(Mechanism)>;
[[nodiscard]] std::variant<LoadedTrain, int> loadTrain(const Arguments& arguments,
                                                       const AdaptDocument& adapt = {});

}  // namespace geargraph::cli
