// The train as the 3D view shows it: pictures, animations, and its solids.

#include <algorithm>
#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/view3d_options.h"
#include "core/presentation/mechanism_scene/forces_caption.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/mechanism_scene/train_forces.h"
#include "core/presentation/mechanism_scene/train_power.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/teaching/derivation/solved_statics.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNothingToShow{"no-spanning-tree",
                                       toTranslate("The turning joints are no spanning tree.")};

struct ShownStage {
  SnapshotPtr snapshot;
  MechanismScenePtr stage;
};

std::variant<ShownStage, ExportError> shownStage(ExportContext& context, const OptionValues& given,
                                                 const std::stop_token& stop) {
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  auto analyzed = context.complete(std::get<Mechanism>(std::move(document)), stop);
  if (auto* error = std::get_if<ExportError>(&analyzed)) return std::move(*error);
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  GearCache cache;
  ShapeCache read;
  const ShapeSource shapes{read, context.folder(), stop};
  const MechanismScenePtr stage = mechanismScene(*snapshot, cache, &shapes, nullptr, stop);
  if (!stage) return outOfTime(translated("the 3D view"));
  for (const SceneNote& note : stage->notes) context.tell(note.text, ExportNote::About::file);
  if (stage->scene.instances.empty() && snapshot->mechanism->n() > kMaxStageLinks) {
    return ExportError{ExportError::Kind::limit,
                       translated("A train of %1 links has no 3D, which is made of up to %2 links.",
                                  {std::to_string(snapshot->mechanism->n()), std::to_string(kMaxStageLinks)}),
                       kTooLargeRefusal.code};
  }
  if (!stage->scene.instances.empty()) return ShownStage{snapshot, stage};
  return ExportError{ExportError::Kind::mechanism,
                     translated("There is nothing to show: the turning joints are no spanning tree."),
                     kNothingToShow.code};
}

/// What `--show forces` adds to a picture.
struct ForcesInPicture {
  SceneForces forces;   ///< null where none is determined
  std::string caption;  ///< why some are not drawn, or all; where all, under which loads
  bool areUnheld = false;
};

/// The forces under the document's loads. Where some are not known the train is shown without them, and the
/// picture says why; that is told. An error where a stop was requested.
std::variant<ForcesInPicture, ExportError> shownForces(const ExportContext& context,
                                                       const SnapshotPtr& snapshot, const OptionValues& given,
                                                       const std::stop_token& stop) {
  const SolvedStaticsPtr solved = solvedStatics(snapshot, given.value("--state"), false, stop);
  if (!solved) return outOfTime(translated("the torques"));
  const SolvedStatics& statics = *solved;
  const Mechanism& mechanism = *snapshot->mechanism;
  const StaticsReport* const report = statics.report ? &*statics.report : nullptr;
  ForcesInPicture shown;
  std::vector<SceneForce> forces;
  if (report != nullptr) forces = stageForces(mechanism, statics.snapshot->kinematics->placement(), *report);
  shown.caption = forcesCaption(mechanism, report);
  if (!shown.caption.empty()) {
    if (report != nullptr) context.tell(report->diagnostics);
    context.tell("--show forces: " + shown.caption);
  }
  if (forces.empty()) {
    const std::string loads = loadsCaption(mechanism, report);
    if (!loads.empty()) shown.caption = loads + ' ' + shown.caption;
  } else {
    shown.forces = std::make_shared<const std::vector<SceneForce>>(std::move(forces));
  }
  shown.areUnheld = report != nullptr && hasErrors(report->diagnostics);
  return shown;
}

/// What `--show power` adds to a picture.
struct ShownPower {
  ScenePowerPtr power;  ///< null where there is none
  std::string caption;  ///< why
  bool areUnheld = false;
};

std::string whyNoShownPower(const StaticsReport* report) {
  if (report == nullptr || report->loads.empty())
    return translated("No power without loads: add one in Forces.");
  if (!report->isSolved || !report->lossless.isBalanced())
    return translated("No power: the loads are not in balance. Forces names what is missing.");
  if (!report->isAnswered()) return translated("No power: with these losses no torques are known.");
  if (!report->flow) return translated("No power without a motion.");
  return {};
}

/// The power under the document's loads, seen from the ground. Where there is none the picture says why, and
/// that is told. An error where a stop was requested.
std::variant<ShownPower, ExportError> shownPower(const ExportContext& context, const ShownStage& from,
                                                 const OptionValues& given, const std::stop_token& stop) {
  const auto& [snapshot, stage] = from;
  const SolvedStaticsPtr solved = solvedStatics(snapshot, given.value("--state"), false, stop);
  if (!solved) return outOfTime(translated("the torques"));
  const StaticsReport* const report = solved->report ? &*solved->report : nullptr;
  ShownPower shown;
  shown.caption = whyNoShownPower(report);
  shown.areUnheld = report != nullptr && hasErrors(report->diagnostics);
  if (!shown.caption.empty()) {
    if (report != nullptr) context.tell(report->diagnostics);
    context.tell("--show power: " + shown.caption);
    return shown;
  }
  const Mechanism& mechanism = *snapshot->mechanism;
  const auto& kinematics = *solved->snapshot->kinematics;
  shown.power = std::make_shared<const ScenePower>(
      stagePower(powerPicture(mechanism, *kinematics.model, kinematics.placement(), *report), mechanism,
                 kinematics.placement(), *stage));
  if (shown.power->picture.isEmpty()) {
    shown.caption = translated("No power flows: the loads and what holds them do no work in this motion.");
    context.tell("--show power: " + shown.caption);
  }
  return shown;
}

/// The limits of joints between which a film of a motion goes there and back; empty without any.
std::string limitsNote(const MechanismScene& stage, const SceneRendering& rendering) {
  if (!rendering.animation || rendering.animation->kind != AnimationKind::motion || !stage.range) return {};
  const SceneRange range = stage.range(std::vector<double>(stage.inputSpeeds.size(), 0));
  std::vector<std::string> ends;
  for (const SceneLimit* end : {&range.from, &range.to})
    if (!end->text.empty()) ends.push_back(end->text);
  if (ends.empty()) return {};
  return translated("The motion in the file goes there and back within the limits of joints: %1.",
                    {listed(ends, kAllNames)});
}

ExportError renderingError(const RenderingFailure& why) {
  if (why.kind == RenderingFailure::Kind::stopped) return outOfTime(translated("the picture"));
  if (why.kind == RenderingFailure::Kind::file) return {ExportError::Kind::file, why.message};
  return {ExportError::Kind::limit, why.message, kGraphicsRefusal.code};
}

/// The rendering of the options, with what was found out about the forces that it shows.
struct AskedRendering {
  ShownStage from;
  SceneRendering rendering;
  ForcesInPicture forces;
};

std::variant<AskedRendering, ExportError> askedRendering(ExportContext& context, const OptionValues& given,
                                                         const ExportTarget& target,
                                                         const std::stop_token& stop) {
  if (auto error = renderingUsageError(given))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  if (given.has("--all") && target.path == "-")
    return ExportError{ExportError::Kind::usage, translated("--all writes a folder; \"-\" is none.")};
  auto made = shownStage(context, given, stop);
  if (auto* error = std::get_if<ExportError>(&made)) return std::move(*error);
  AskedRendering asked{std::get<ShownStage>(std::move(made)), {}, {}};
  auto parsed = renderingFrom(given, asked.from.stage, *asked.from.snapshot);
  if (auto* error = std::get_if<UsageError>(&parsed))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  asked.rendering = std::get<SceneRendering>(std::move(parsed));
  if (std::string note = limitsNote(*asked.from.stage, asked.rendering); !note.empty())
    context.tell(std::move(note));
  if (!asked.rendering.view.marks.forces) return asked;
  auto forces = shownForces(context, asked.from.snapshot, given, stop);
  if (auto* error = std::get_if<ExportError>(&forces)) return std::move(*error);
  asked.forces = std::get<ForcesInPicture>(std::move(forces));
  asked.rendering.view.forces = asked.forces.forces;
  return asked;
}

ExportResult writeSeenSolids(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                             const std::stop_token& stop) {
  const auto made = askedRendering(context, given, target, stop);
  if (const auto* error = std::get_if<ExportError>(&made)) return *error;
  const auto& asked = std::get<AskedRendering>(made);
  const MeshWriteOptions options{target.progress, stop};
  const MeshScene scene = sceneOf(*asked.from.stage, asked.rendering.view, stop);
  if (const auto why = writeMesh(scene, MeshFormat::glb, target.path, options)) return meshErrorOf(*why);
  return ExportOutcome{hasErrors(asked.from.snapshot->diagnostics) || asked.forces.areUnheld};
}

/// Paints labels, captions and the power over each picture.
std::function<void(Image&, ScenePainter&)> overlayPainter(const OverlayChoice& overlay,
                                                          const AskedRendering& asked,
                                                          const ShownPower& power, Theme theme) {
  SceneLabels over(overlay);
  const bool both = !asked.forces.caption.empty() && !power.caption.empty();
  over.setCaption(asked.forces.caption + (both ? " " : "") + power.caption);
  over.setPower(power.power);
  return [labels = std::move(over), theme](Image& image, ScenePainter& painter) mutable {
    const bool painted =
        paintOver(image.rgba, image.width, image.height, labels.over(painter), painter.pixelRatio(), theme);
    if (!painted) image.rgba.clear();
  };
}

ExportResult writeRendering(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                            const std::stop_token& stop) {
  const auto made = askedRendering(context, given, target, stop);
  if (const auto* error = std::get_if<ExportError>(&made)) return *error;
  const auto& asked = std::get<AskedRendering>(made);
  const OverlayChoice overlay = overlayOf(given);
  ShownPower power;
  if (overlay.power) {
    auto found = shownPower(context, asked.from, given, stop);
    if (auto* error = std::get_if<ExportError>(&found)) return std::move(*error);
    power = std::get<ShownPower>(std::move(found));
  }
  RenderingRun run;
  run.stop = stop;
  run.mayOverwrite = target.mayOverwrite;
  if (target.progress) {
    run.progress = [&target](int done, int all) {
      target.progress(static_cast<double>(done) / std::max(all, 1));
    };
  }
  if (overlay.any())
    run.finish = overlayPainter(overlay, asked, power, given.has("--dark") ? Theme::dark : Theme::light);
  const auto why = given.has("--all") ? writePictures(asked.rendering, target.path, run)
                                      : writePicture(asked.rendering, target.path, run);
  if (why) return renderingError(*why);
  return ExportOutcome{hasErrors(asked.from.snapshot->diagnostics) || asked.forces.areUnheld ||
                       power.areUnheld};
}

std::vector<std::string> namesOfStandardViews() {
  return {"front", "back", "left", "right", "top", "bottom", "iso"};
}
std::vector<std::string> namesOfFaces() {
  return {"shaded", "lines", "edges"};
}

constexpr double kMaxPictureTime = 1e9;  // s

constexpr ExportOption kTime = numberOption("--time", -kMaxPictureTime, kMaxPictureTime, "0", "s");
constexpr ExportOption kExplode = numberOption("--explode", 0, 1, "0");
constexpr ExportOption kHide = textOption("--hide");
constexpr ExportOption kRide = textOption("--ride");
constexpr ExportOption kRate = numberOption("--fps", 0.1, 100, "24");
constexpr ExportOption kFrames =
    numberOption("--frames", 2, kMaxAnimationFrames, "72", toTranslate("pictures"), true);

constexpr std::array kRenderingOptions = {textOption("--size"),
                                          flagOption("--dark"),
                                          flagOption("--transparent"),
                                          choiceOption("--from", namesOfStandardViews),
                                          textOption("--camera"),
                                          kTime,
                                          textOption("--section"),
                                          kExplode,
                                          choiceOption("--faces", namesOfFaces, "shaded"),
                                          textOption("--show"),
                                          kHide,
                                          kRide};

template <std::size_t count>
constexpr auto withAnimation(const std::array<ExportOption, count>& options) {
  std::array<ExportOption, count + 2> all;
  std::copy(options.begin(), options.end(), all.begin());
  all[count] = kRate;
  all[count + 1] = kFrames;
  return all;
}
constexpr auto kAnimationOptions = withAnimation(kRenderingOptions);
constexpr std::array kSeenSolidOptions = {kTime, kExplode, kHide, kRide};

using Implied = std::pair<std::string_view, std::string_view>;
constexpr Implied kIn3D{"--view", "3d"};
constexpr std::array kPictureImplied = {kIn3D};
constexpr std::array kTurntableImplied = {kIn3D, Implied{"--turntable", ""}};
constexpr std::array kMotionImplied = {kIn3D, Implied{"--motion", ""}};
constexpr std::array kTurntablesImplied = {kIn3D, Implied{"--turntable", ""}, Implied{"--all", ""}};
constexpr std::array kMotionsImplied = {kIn3D, Implied{"--motion", ""}, Implied{"--all", ""}};

constexpr std::array kPictureRefusals = {&kNothingToShow, &kTooLargeRefusal, &kGraphicsRefusal};
constexpr std::string_view kPictureOfTrain = toTranslate("a picture");
constexpr std::string_view kAnimationOfTrain = toTranslate("an animation");

constexpr Exporter animationExporter(std::string_view id, std::string_view title,
                                     std::span<const Implied> implied, bool isFolder) {
  return {id,
          "png",
          title,
          kAnimationOfTrain,
          isFolder ? ExportFiles::folder : ExportFiles::file,
          isFolder ? std::string_view() : "png",
          kAnimationOptions,
          implied,
          ExportNeed::tree,
          kPictureRefusals,
          writeRendering};
}

constexpr std::array kPictureExporters = {
    Exporter{"png-3d", "png", toTranslate("PNG, a picture of the train"), kPictureOfTrain, ExportFiles::file,
             "png", kRenderingOptions, kPictureImplied, ExportNeed::tree, kPictureRefusals, writeRendering}};
constexpr std::array kAnimationExporters = {
    animationExporter("turntable", toTranslate("PNG, once round the train"), kTurntableImplied, false),
    animationExporter("motion", toTranslate("PNG, one period of the motion"), kMotionImplied, false),
    animationExporter("turntable-pictures", toTranslate("PNG, once round the train, a file for each picture"),
                      kTurntablesImplied, true),
    animationExporter("motion-pictures",
                      toTranslate("PNG, one period of the motion, a file for each picture"), kMotionsImplied,
                      true)};
constexpr std::array kFewPictures = {Implied{"--frames", "2"}};
constexpr std::array kSeenSolidExporters = {
    Exporter{"glb-3d", "glb", toTranslate("GLB, the train as seen"), toTranslate("solids"), ExportFiles::file,
             "glb", kSeenSolidOptions, kPictureImplied, ExportNeed::tree, kPictureRefusals, writeSeenSolids}};

}  // namespace

ExportFamily pictureFamily() {
  return {toTranslate("3D pictures"), toTranslate("3D pictures"), "--to png --view 3d", true,
          kPictureExporters,          ExportPurpose::print};
}

ExportFamily animationFamily() {
  return {toTranslate("Animations"),
          toTranslate("animations"),
          "--turntable, --motion",
          true,
          kAnimationExporters,
          ExportPurpose::web,
          {},
          kFewPictures};
}

ExportFamily seenSolidFamily() {
  return {toTranslate("The train as seen"),
          {},
          "--to glb --view 3d",
          true,
          kSeenSolidExporters,
          ExportPurpose::web,
          "png-3d"};
}

}  // namespace geargraph
