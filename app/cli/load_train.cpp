#include "app/cli/load_train.h"

#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/time_limit.h"
#include "core/machine/bodies/derived_geometry.h"
#include "core/presentation/train_stage/train_stage.h"

namespace geargraph::cli {
namespace {

std::vector<std::vector<Rational>> motionsOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  std::vector<std::vector<Rational>> motions;
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution) return motions;
  const std::vector<int>& inputs = matroid->choice.joints;
  for (const auto& speeds : {matroid->speeds, restlessSpeeds(inputs.size())}) {
    if (auto solution = solveExact(*snapshot.kinematics->model, inputs, speeds, stop)) {
      motions.push_back(std::move(solution->rates));
    }
  }
  return motions;
}

}  // namespace

std::variant<LoadedTrain, int> loadTrain(const Arguments& arguments, const AdaptDocument& adapt) {
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  if (adapt) {
    auto adapted = adapt(std::get<Mechanism>(std::move(document)));
    if (const auto* error = std::get_if<UsageError>(&adapted)) return wrongUsage(kExport, error->message);
    document = std::get<Mechanism>(std::move(adapted));
  }
  const int links = std::get<Mechanism>(document).n();
  if (links > kMostStageLinks && !arguments.has("--gear") && !arguments.has("--link")) {
    std::cerr << "geargraph-cli: A train of " << links << " links has no 3D, which is made of up to "
              << kMostStageLinks << " links; --gear and --link export a part of it. Nothing was written.\n";
    return static_cast<int>(kResourceLimit);
  }
  LoadedTrain loaded;
  loaded.snapshot = analyzeLive(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(document))),
                                0, arguments.stop);
  if (!loaded.snapshot) return outOfTime(arguments, "the analysis");
  const AnalysisSnapshot& snapshot = *loaded.snapshot;
  std::cerr << diagnosticLines(file, snapshot.diagnostics);
  if (hasErrors(snapshot.diagnostics) || !snapshot.kinematics) {
    std::cerr << "geargraph-cli: A mechanism with errors has no gears; nothing was written.\n";
    return static_cast<int>(kMechanismErrors);
  }
  const auto train = snapshot.geometry->train(arguments.stop);
  const auto found = snapshot.geometry->diagnostics(arguments.stop);
  if (!train || !found) return outOfTime(arguments, "the gear train");
  loaded.train = *train;
  std::cerr << diagnosticLines(file, *found);
  if (loaded.train.hasSimpleBodies) {
    std::cerr << "geargraph-cli: A train of " << loaded.train.gears.size() << " gears (over "
              << kMostRoutedGears
              << "): wheels are plain discs, shafts and arms are straight and pass through other parts.\n";
  }
  loaded.motions = motionsOf(snapshot, arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, "the motion");
  return loaded;
}

}  // namespace geargraph::cli
