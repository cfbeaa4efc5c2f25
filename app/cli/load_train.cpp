#include "app/cli/load_train.h"

#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"

namespace geargraph::cli {
namespace {

std::vector<std::vector<Rational>> motionsOf(const AnalysisSnapshot& snapshot) {
  std::vector<std::vector<Rational>> motions;
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution) return motions;
  const std::vector<int>& inputs = matroid->choice.joints;
  for (const auto& speeds : {matroid->speeds, restlessSpeeds(inputs.size())}) {
    if (auto solution = solveExact(*snapshot.kinematics->model, inputs, speeds)) {
      motions.push_back(std::move(solution->rates));
    }
  }
  return motions;
}

}  // namespace

std::variant<LoadedTrain, int> loadTrain(const std::string& file) {
  auto document = loadOrSay(file);
  if (const int* status = std::get_if<int>(&document)) return *status;
  LoadedTrain loaded;
  loaded.snapshot = analyzeLive(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(document))));
  const AnalysisSnapshot& snapshot = *loaded.snapshot;
  std::cerr << diagnosticLines(file, snapshot.diagnostics);
  if (hasErrors(snapshot.diagnostics) || !snapshot.kinematics) {
    std::cerr << "geargraph-cli: A mechanism with errors has no gears; nothing was written.\n";
    return static_cast<int>(kMechanismErrors);
  }
  loaded.train = trainOf(loaded.mechanism(), snapshot.kinematics->placement);
  std::cerr << diagnosticLines(file, loaded.train.diagnostics);
  loaded.motions = motionsOf(snapshot);
  return loaded;
}

}  // namespace geargraph::cli
