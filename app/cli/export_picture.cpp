// `export FILE --to png/glb --view 3d -o OUT`: the train as the 3D view shows it, without a display.

#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "app/cli/view3d_options.h"
#include "core/foundations/files/file.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/picture/picture.h"
#include "core/presentation/results/solved_statics.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/presentation/train_stage/train_forces.h"
#include "core/presentation/train_stage/train_stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {
namespace {

std::variant<std::pair<SnapshotPtr, StagePtr>, int> stageOf(const Arguments& arguments) {
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  const SnapshotPtr snapshot =
      analyze(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(document))), 0, arguments.stop);
  if (!snapshot) return outOfTime(arguments, "the analysis");
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  GearCache cache;
  ShapeCache read;
  const ShapeSource shapes{read, file == "-" ? "." : std::filesystem::absolute(file).parent_path(),
                           arguments.stop};
  const StagePtr stage = trainStage(*snapshot, cache, &shapes, nullptr, arguments.stop);
  if (!stage) return outOfTime(arguments, "the 3D view");
  for (const StageNote& note : stage->notes) std::cerr << file << ": " << note.text << '\n';
  if (stage->scene.instances.empty() && snapshot->mechanism->n() > kMostStageLinks) {
    std::cerr << "geargraph-cli: A train of " << snapshot->mechanism->n()
              << " links has no 3D, which is made of up to " << kMostStageLinks << " links.\n";
    return static_cast<int>(kResourceLimit);
  }
  if (!stage->scene.instances.empty()) return std::pair(snapshot, stage);
  std::cerr << "geargraph-cli: There is nothing to show: the turning joints are no spanning tree.\n";
  return static_cast<int>(kMechanismErrors);
}

/// The forces under the document's loads; the exit status where there are none.
std::variant<StageForces, int> forcesOf(const SnapshotPtr& snapshot, const Arguments& arguments) {
  const SolvedStaticsPtr solved = solvedStatics(snapshot, arguments.value("--state"), false, arguments.stop);
  if (!solved) return outOfTime(arguments, "the torques");
  const SolvedStatics& statics = *solved;
  std::vector<StageForce> forces;
  if (statics.report)
    forces = stageForces(*snapshot->mechanism, statics.snapshot->kinematics->placement(), *statics.report);
  if (!forces.empty()) return std::make_shared<const std::vector<StageForce>>(std::move(forces));
  if (statics.report) std::cerr << diagnosticLines(arguments.files.front(), statics.report->diagnostics);
  const bool isShared = statics.report && statics.report->lossless.indeterminate() > 0;
  std::cerr << (isShared ? "geargraph-cli: --show forces needs forces that are determined: here meshes share "
                           "the load in unknown parts; nothing was written.\n"
                         : "geargraph-cli: --show forces needs loads, balances that hold them, and a unit of "
                           "length whose size is known; nothing was written.\n");
  return static_cast<int>(kMechanismErrors);
}

int failure(const Arguments& arguments, const ShotFailure& why) {
  if (why.kind == ShotFailure::Kind::stopped) return outOfTime(arguments, "the picture");
  if (why.kind == ShotFailure::Kind::file) return fileFailure(why.message);
  std::cerr << "geargraph-cli: " << why.message << '\n';
  return kResourceLimit;
}

int failure(const Arguments& arguments, const MeshFileError& why) {
  if (why.kind == MeshFileError::Kind::stopped) return outOfTime(arguments, "the file");
  std::cerr << "geargraph-cli: " << why.message << '\n';
  return why.kind == MeshFileError::Kind::limit ? kResourceLimit : kUsageOrFile;
}

}  // namespace

std::optional<std::pair<int, int>> pictureSize(std::string_view text, int most) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = numberFrom<int>(text.substr(0, cross)), height = numberFrom<int>(text.substr(cross + 1));
  const auto fits = [most](const auto& side) { return side && *side >= kLeastPictureSide && *side <= most; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return std::pair(*width, *height);
}

std::string wrongSize(std::string_view text, int most) {
  return "--size takes WIDTHxHEIGHT, each from " + std::to_string(kLeastPictureSide) + " to " +
         std::to_string(most) + ", not \"" + std::string(text) + "\".";
}

int writePicture(std::string_view bytes, const std::string& path) {
  if (path == "-") {
    StandardOutput out;
    out.write(bytes);
    return out.failed() ? fileFailure("Standard output could not be written.") : kFine;
  }
  const auto error = writeFile(path, bytes);
  return error ? fileFailure(error->message) : kFine;
}

int exportPicture(const Arguments& arguments, bool asSolids) {
  if (const auto error = wrongShot(arguments)) return wrongUsage(kExport, error->message);
  const std::string path = *arguments.value("-o");
  if (arguments.has("--all") && path == "-")
    return wrongUsage(kExport, "--all writes a folder; \"-\" is none.");
  const auto made = stageOf(arguments);
  if (const int* status = std::get_if<int>(&made)) return *status;
  const auto& [snapshot, stage] = std::get<0>(made);
  const auto wish = shotOf(arguments, stage, *snapshot);
  if (const auto* error = std::get_if<UsageError>(&wish)) return wrongUsage(kExport, error->message);
  auto shot = std::get<StageShot>(wish);
  if (shot.view.marks.forces) {
    auto forces = forcesOf(snapshot, arguments);
    if (const int* status = std::get_if<int>(&forces)) return *status;
    shot.view.forces = std::get<StageForces>(std::move(forces));
  }
  if (asSolids) {
    MeshWriteOptions options;
    options.stop = arguments.stop;
    if (const auto why = writeMesh(sceneOf(*stage, shot.view), MeshFormat::glb, path, options))
      return failure(arguments, *why);
  } else {
    ShotRun run;
    run.stop = arguments.stop;
    run.mayOverwrite = arguments.has("--force");
    const OverlayChoice overlay = overlayOf(arguments);
    if (overlay.any()) {
      const Theme theme = arguments.has("--dark") ? Theme::dark : Theme::light;
      run.finish = [labels = StageLabels(overlay), theme](Image& image, StagePainter& painter) mutable {
        const bool painted = paintOver(image.rgba, image.width, image.height, labels.over(painter),
                                       painter.pixelRatio(), theme);
        if (!painted) image.rgba.clear();
      };
    }
    const auto why =
        arguments.has("--all") ? writePictures(shot, path, run) : geargraph::writePicture(shot, path, run);
    if (why) return failure(arguments, *why);
  }
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
