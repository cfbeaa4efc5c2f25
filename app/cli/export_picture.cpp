// `export FILE --to png/glb --view 3d -o OUT`: the train as the 3D view shows it, without a display.

#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "app/cli/view3d_options.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/file.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/picture/picture.h"
#include "core/presentation/results/solved_statics.h"
#include "core/presentation/train_stage/forces_caption.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/presentation/train_stage/train_forces.h"
#include "core/presentation/train_stage/train_power.h"
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
  if (!snapshot) return outOfTime(arguments, translated("the analysis"));
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  GearCache cache;
  ShapeCache read;
  const ShapeSource shapes{read, file == "-" ? "." : std::filesystem::absolute(file).parent_path(),
                           arguments.stop};
  const StagePtr stage = trainStage(*snapshot, cache, &shapes, nullptr, arguments.stop);
  if (!stage) return outOfTime(arguments, translated("the 3D view"));
  for (const StageNote& note : stage->notes) std::cerr << file << ": " << note.text << '\n';
  if (stage->scene.instances.empty() && snapshot->mechanism->n() > kMaxStageLinks) {
    std::cerr << "geargraph-cli: "
              << translated("A train of %1 links has no 3D, which is made of up to %2 links.",
                            {std::to_string(snapshot->mechanism->n()), std::to_string(kMaxStageLinks)})
              << '\n';
    return static_cast<int>(kResourceLimit);
  }
  if (!stage->scene.instances.empty()) return std::pair(snapshot, stage);
  std::cerr << "geargraph-cli: "
            << translated("There is nothing to show: the turning joints are no spanning tree.") << '\n';
  return static_cast<int>(kMechanismErrors);
}

/// What `--show forces` adds to a picture.
struct ShownForces {
  StageForces forces;   ///< null where none is determined
  std::string caption;  ///< why some are not drawn, or all; where all, under which loads
  bool areUnheld = false;
};

/// The forces under the document's loads. Where some are not known the train is shown without them, and the
/// picture says why; so does standard error. The exit status where the time is over.
std::variant<ShownForces, int> forcesOf(const SnapshotPtr& snapshot, const Arguments& arguments) {
  const SolvedStaticsPtr solved = solvedStatics(snapshot, arguments.value("--state"), false, arguments.stop);
  if (!solved) return outOfTime(arguments, translated("the torques"));
  const SolvedStatics& statics = *solved;
  const Mechanism& mechanism = *snapshot->mechanism;
  const StaticsReport* const report = statics.report ? &*statics.report : nullptr;
  ShownForces shown;
  std::vector<StageForce> forces;
  if (report != nullptr) forces = stageForces(mechanism, statics.snapshot->kinematics->placement(), *report);
  shown.caption = forcesCaption(mechanism, report);
  if (!shown.caption.empty()) {
    if (report != nullptr) std::cerr << diagnosticLines(arguments.files.front(), report->diagnostics);
    std::cerr << "geargraph-cli: --show forces: " << shown.caption << '\n';
  }
  if (forces.empty()) {
    const std::string loads = loadsCaption(mechanism, report);
    if (!loads.empty()) shown.caption = loads + ' ' + shown.caption;
  } else {
    shown.forces = std::make_shared<const std::vector<StageForce>>(std::move(forces));
  }
  shown.areUnheld = report != nullptr && hasErrors(report->diagnostics);
  return shown;
}

/// What `--show power` adds to a picture.
struct ShownPower {
  StagePowerPtr power;  ///< null where there is none
  std::string caption;  ///< why
  bool areUnheld = false;
};

std::string whyNoPower(const StaticsReport* report) {
  if (report == nullptr || report->loads.empty())
    return translated("No power without loads: add one in Forces.");
  if (!report->isSolved || !report->lossless.isBalanced())
    return translated("No power: the loads are not in balance. Forces names what is missing.");
  if (!report->isAnswered()) return translated("No power: with these losses no torques are known.");
  if (!report->flow) return translated("No power without a motion.");
  return {};
}

/// The power under the document's loads, seen from the ground. Where there is none the picture says why, and
/// so does standard error. The exit status where the time is over.
std::variant<ShownPower, int> powerOf(const SnapshotPtr& snapshot, const StagePtr& stage,
                                      const Arguments& arguments) {
  const SolvedStaticsPtr solved = solvedStatics(snapshot, arguments.value("--state"), false, arguments.stop);
  if (!solved) return outOfTime(arguments, translated("the torques"));
  const StaticsReport* const report = solved->report ? &*solved->report : nullptr;
  ShownPower shown;
  shown.caption = whyNoPower(report);
  shown.areUnheld = report != nullptr && hasErrors(report->diagnostics);
  if (!shown.caption.empty()) {
    if (report != nullptr) std::cerr << diagnosticLines(arguments.files.front(), report->diagnostics);
    std::cerr << "geargraph-cli: --show power: " << shown.caption << '\n';
    return shown;
  }
  const Mechanism& mechanism = *snapshot->mechanism;
  const auto& kinematics = *solved->snapshot->kinematics;
  shown.power = std::make_shared<const StagePower>(
      stagePower(powerPicture(mechanism, *kinematics.model, kinematics.placement(), *report), mechanism,
                 kinematics.placement(), *stage));
  if (shown.power->picture.isEmpty()) {
    shown.caption = translated("No power flows: the loads and what holds them do no work in this motion.");
    std::cerr << "geargraph-cli: --show power: " << shown.caption << '\n';
  }
  return shown;
}

int failure(const Arguments& arguments, const RenderingFailure& why) {
  if (why.kind == RenderingFailure::Kind::stopped) return outOfTime(arguments, translated("the picture"));
  if (why.kind == RenderingFailure::Kind::file) return fileFailure(why.message);
  std::cerr << "geargraph-cli: " << why.message << '\n';
  return kResourceLimit;
}

int failure(const Arguments& arguments, const MeshFileError& why) {
  if (why.kind == MeshFileError::Kind::stopped) return outOfTime(arguments, translated("the file"));
  std::cerr << "geargraph-cli: " << why.message << '\n';
  return why.kind == MeshFileError::Kind::limit ? kResourceLimit : kUsageOrFile;
}

/// The limits of joints between which a film of a motion goes there and back; empty without any.
std::string limitsNote(const Stage& stage, const StageRendering& rendering) {
  if (!rendering.animation || rendering.animation->kind != AnimationKind::motion || !stage.range) return {};
  const StageRange range = stage.range(std::vector<double>(stage.inputSpeeds.size(), 0));
  std::vector<std::string> ends;
  for (const StageLimit* end : {&range.from, &range.to})
    if (!end->text.empty()) ends.push_back(end->text);
  if (ends.empty()) return {};
  return translated("The motion in the file goes there and back within the limits of joints: %1.",
                    {listed(ends, kAllNames)});
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
  return translated("--size takes WIDTHxHEIGHT, each from %1 to %2, not \"%3\".",
                    {std::to_string(kLeastPictureSide), std::to_string(most), text});
}

int writePicture(std::string_view bytes, const std::string& path) {
  if (path == "-") {
    StandardOutput out;
    out.write(bytes);
    return out.failed() ? fileFailure(translated("Standard output could not be written.")) : kFine;
  }
  const auto error = writeFile(path, bytes);
  return error ? fileFailure(error->message) : kFine;
}

int exportPicture(const Arguments& arguments, bool asSolids) {
  if (const auto error = renderingUsageError(arguments)) return wrongUsage(kExport, error->message);
  const std::string path = *arguments.value("-o");
  if (arguments.has("--all") && path == "-")
    return wrongUsage(kExport, translated("--all writes a folder; \"-\" is none."));
  const auto made = stageOf(arguments);
  if (const int* status = std::get_if<int>(&made)) return *status;
  const auto& [snapshot, stage] = std::get<0>(made);
  const auto parsed = renderingFrom(arguments, stage, *snapshot);
  if (const auto* error = std::get_if<UsageError>(&parsed)) return wrongUsage(kExport, error->message);
  auto rendering = std::get<StageRendering>(parsed);
  if (const std::string note = limitsNote(*stage, rendering); !note.empty())
    std::cerr << "geargraph-cli: " << note << '\n';
  ShownForces shown;
  if (rendering.view.marks.forces) {
    auto forces = forcesOf(snapshot, arguments);
    if (const int* status = std::get_if<int>(&forces)) return *status;
    shown = std::get<ShownForces>(std::move(forces));
    rendering.view.forces = shown.forces;
  }
  const OverlayChoice overlay = overlayOf(arguments);
  ShownPower power;
  if (overlay.power && !asSolids) {
    auto found = powerOf(snapshot, stage, arguments);
    if (const int* status = std::get_if<int>(&found)) return *status;
    power = std::get<ShownPower>(std::move(found));
  }
  if (asSolids) {
    MeshWriteOptions options;
    options.stop = arguments.stop;
    if (const auto why = writeMesh(sceneOf(*stage, rendering.view), MeshFormat::glb, path, options))
      return failure(arguments, *why);
  } else {
    RenderingRun run;
    run.stop = arguments.stop;
    run.mayOverwrite = arguments.has("--force");
    if (overlay.any()) {
      const Theme theme = arguments.has("--dark") ? Theme::dark : Theme::light;
      StageLabels over(overlay);
      const bool both = !shown.caption.empty() && !power.caption.empty();
      over.setCaption(shown.caption + (both ? " " : "") + power.caption);
      over.setPower(power.power);
      run.finish = [labels = std::move(over), theme](Image& image, StagePainter& painter) mutable {
        const bool painted = paintOver(image.rgba, image.width, image.height, labels.over(painter),
                                       painter.pixelRatio(), theme);
        if (!painted) image.rgba.clear();
      };
    }
    const auto why = arguments.has("--all") ? writePictures(rendering, path, run)
                                            : geargraph::writePicture(rendering, path, run);
    if (why) return failure(arguments, *why);
  }
  return hasErrors(snapshot->diagnostics) || shown.areUnheld || power.areUnheld ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
