#include "app/cli/load_train.h"

#include <algorithm>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "core/analysis/analysis.h"
#include "core/matroid/exact_solution.h"
#include "core/matroid/matroid_analysis.h"

namespace geargraph::cli {
namespace {

/// Adds what is not known yet: stages of the analysis may report the same.
void addNew(Diagnostics& all, const Diagnostics& more) {
  for (const Diagnostic& diagnostic : more) {
    if (std::find(all.begin(), all.end(), diagnostic) == all.end()) all.push_back(diagnostic);
  }
}

void addMotions(LoadedTrain& loaded, const DigraphPtr& graph, Diagnostics& diagnostics) {
  const auto model = KinematicModel::of(loaded.mechanism, graph, loaded.tree, loaded.placement);
  if (!model) return;
  const auto analysis = analyzeMatroid(loaded.mechanism, *model, loaded.placement);
  if (!analysis) return;
  addNew(diagnostics, analysis->diagnostics);
  const std::vector<int>& inputs = analysis->choice.joints;
  for (const auto& speeds : {analysis->speeds, restlessSpeeds(inputs.size())}) {
    if (auto solution = solveExact(*model, inputs, speeds))
      loaded.motions.push_back(std::move(solution->rates));
  }
}

}  // namespace

std::variant<std::unique_ptr<const LoadedTrain>, int> loadTrain(const std::string& file) {
  auto document = load(file);
  if (const auto* error = std::get_if<FileError>(&document)) return fileFailure(error->message);
  auto& read = std::get<Expected<Mechanism>>(document);
  if (!read) {
    std::cerr << diagnosticLines(file, read.error());
    return static_cast<int>(kMechanismErrors);
  }
  auto loaded = std::make_unique<LoadedTrain>();
  loaded->mechanism = std::move(read).value();
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(loaded->mechanism));
  Diagnostics diagnostics = snapshot->diagnostics;
  loaded->tree = snapshot->tree;
  if (loaded->tree) {
    loaded->placement = placementOf(loaded->mechanism);
    addNew(diagnostics, loaded->placement.diagnostics);
    addMotions(*loaded, snapshot->graph, diagnostics);
    loaded->train = trainOf(loaded->mechanism, loaded->placement);
    addNew(diagnostics, loaded->train.diagnostics);
  }
  std::cerr << diagnosticLines(file, diagnostics);
  if (hasErrors(diagnostics) || !loaded->tree) {
    std::cerr << "geargraph-cli: A mechanism with errors has no gears; nothing was written.\n";
    return static_cast<int>(kMechanismErrors);
  }
  return loaded;
}

}  // namespace geargraph::cli
