#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/element_words.h"
#include "app/cli/export_forms.h"
#include "app/cli/load_train.h"
#include "app/cli/number_options.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/words.h"
#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/results/train_export.h"

namespace geargraph::cli {
namespace {

int failure(const Arguments& arguments, const MeshFileError& error) {
  if (error.kind == MeshFileError::Kind::stopped) return outOfTime(arguments, translated("the file"));
  std::cerr << "geargraph-cli: " << error.message << '\n';
  return error.kind == MeshFileError::Kind::limit ? kResourceLimit : kUsageOrFile;
}

/// The whole train, or one link of it, with its motion where the format carries one; `status` tells whether
/// gears were left out.
std::variant<MeshScene, int> trainScene(const ExportTrain& train, const Arguments& arguments,
                                        MeshFormat format, double tolerance, double seconds, int& status) {
  SolidsChoice choice;
  if (arguments.has("--tolerance")) choice.tolerance = tolerance;
  choice.link = arguments.value("--link");
  if (const auto link = choice.link ? linkNamed(train.mechanism(), *choice.link) : std::nullopt)
    choice.link = std::to_string(train.mechanism().linkLabel(*link));
  choice.moves = carriesAnimation(format);
  choice.seconds = seconds;
  auto made = trainSolids(train, choice, arguments.stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return exportFailure(arguments, *why);
  auto& solids = std::get<TrainSolids>(made);
  if (solids.tolerance != tolerance) {
    std::cerr
        << "geargraph-cli: "
        << translated(
               "The train is so large that its chords are within %1 modules instead of %2 (--tolerance).",
               {readableNumber(solids.tolerance), readableNumber(tolerance)})
        << '\n';
  }
  if (!solids.left.empty()) {
    status = kMechanismErrors;
    std::cerr << diagnosticLines(arguments.files.front(), solids.left) << "geargraph-cli: "
              << translated("Left out: %1 of %2 gears, which cannot be made.",
                            {std::to_string(solids.left.size()), std::to_string(train.train.gears.size())})
              << '\n';
  }
  if (!solids.shows.empty()) std::cerr << "geargraph-cli: " << solids.shows << '\n';
  return std::move(solids.scene);
}

/// One gear, alone in its own frame.
std::variant<MeshScene, int> oneGear(const ExportTrain& train, const Arguments& arguments, double tolerance) {
  auto made = gearScene(train, *arguments.value("--gear"), tolerance);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return exportFailure(arguments, *why);
  return std::get<MeshScene>(std::move(made));
}

}  // namespace

int exportSolids(const Arguments& arguments, MeshFormat format) {
  const auto tolerance =
      numberWithin(arguments, "--tolerance", kExportTolerance, kFinestTolerance, kCoarsestTolerance);
  const auto seconds = numberWithin(arguments, "--animate", 0, kShortestAnimation, kMaxAnimation);
  for (const auto* read : {&tolerance, &seconds}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (arguments.has("--animate") && (!carriesAnimation(format) || arguments.has("--gear"))) {
    return wrongUsage(kExport, translated("Only --to glb of a train or a link carries an animation."));
  }
  if (arguments.has("--gear") && arguments.has("--link")) {
    return wrongUsage(kExport, translated("Give --gear or --link, not both."));
  }
  const auto loaded = loadTrain(arguments);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const auto& train = std::get<ExportTrain>(loaded);
  const double fineness = std::get<double>(tolerance);
  int fine = kFine;
  const auto scene = arguments.has("--gear")
                         ? oneGear(train, arguments, fineness)
                         : trainScene(train, arguments, format, fineness, std::get<double>(seconds), fine);
  if (const int* status = std::get_if<int>(&scene)) return *status;
  MeshWriteOptions options;
  options.stop = arguments.stop;
  const auto error = writeMesh(std::get<MeshScene>(scene), format, *arguments.value("-o"), options);
  return error ? failure(arguments, *error) : fine;
}

int exportAssembly(const Arguments& arguments) {
  const auto tolerance =
      numberWithin(arguments, "--tolerance", kExportTolerance, kFinestTolerance, kCoarsestTolerance);
  const auto frames = numberWithin(arguments, "--frames", 24, static_cast<double>(kMinFrames),
                                   static_cast<double>(kMaxAssemblyFrames));
  for (const auto* read : {&tolerance, &frames}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (*arguments.value("-o") == "-")
    return wrongUsage(kExport, translated("--to assembly writes a folder; \"-\" is none."));
  const auto loaded = loadTrain(arguments);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  auto made = trainAssembly(std::get<ExportTrain>(loaded), std::get<double>(tolerance),
                            static_cast<std::size_t>(std::get<double>(frames)), arguments.stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return exportFailure(arguments, *why);
  const auto error =
      writeAssembly(std::get<Assembly>(made), *arguments.value("-o"), arguments.has("--force"));
  return error ? failure(arguments, *error) : kFine;
}

}  // namespace geargraph::cli
