// Gears, shafts and arms as 3D files, and all gears for a check of their teeth.

#include <array>
#include <cstdio>

#include "core/foundations/base/readable.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/number_options.h"
#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph {
namespace {

/// The whole train, or one link of it, with its motion where the format carries one; `isFlawed` tells whether
/// gears were left out.
std::variant<MeshScene, ExportError> trainScene(const ExportContext& context, const ExportTrain& train,
                                                const OptionValues& given, const SolidsChoice& asked,
                                                double tolerance, bool& isFlawed,
                                                const std::stop_token& stop) {
  SolidsChoice choice = asked;
  if (given.has("--tolerance")) choice.tolerance = tolerance;
  choice.link = given.value("--link");
  if (const auto link = choice.link ? linkNamed(train.mechanism(), *choice.link) : std::nullopt)
    choice.link = std::to_string(train.mechanism().linkLabel(*link));
  auto made = trainSolids(train, choice, stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return context.errorOf(*why);
  auto& solids = std::get<TrainSolids>(made);
  if (solids.tolerance != tolerance) {
    context.tell(
        translated("The train is so large that its chords are within %1 modules instead of %2 (--tolerance).",
                   {readableNumber(solids.tolerance), readableNumber(tolerance)}));
  }
  if (!solids.left.empty()) {
    isFlawed = true;
    context.tell(solids.left);
    context.tell(translated("Left out: %1 of %2 gears, which cannot be made.",
                            {std::to_string(solids.left.size()), std::to_string(train.train.gears.size())}));
  }
  if (!solids.shows.empty()) context.tell(solids.shows);
  return std::move(solids.scene);
}

/// One gear, alone in its own frame.
std::variant<MeshScene, ExportError> oneGear(const ExportContext& context, const ExportTrain& train,
                                             const std::string& name, double tolerance) {
  auto made = gearScene(train, name, tolerance);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return context.errorOf(*why);
  return std::get<MeshScene>(std::move(made));
}

std::variant<ExportTrain, ExportError> trainAsked(ExportContext& context, const OptionValues& given,
                                                  const std::stop_token& stop) {
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  return context.train(std::get<Mechanism>(std::move(document)), given.has("--gear") || given.has("--link"),
                       stop);
}

template <MeshFormat format>
ExportResult writeSolids(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                         const std::stop_token& stop) {
  const auto wrong = [](std::string message) {
    return ExportError{ExportError::Kind::usage, std::move(message)};
  };
  const auto tolerance =
      numberWithin(given, "--tolerance", kExportTolerance, kFinestTolerance, kCoarsestTolerance);
  const auto seconds = numberWithin(given, "--animate", 0, kShortestAnimation, kMaxAnimation);
  for (const auto* read : {&tolerance, &seconds}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrong(error->message);
  }
  if (given.has("--animate") && (!carriesAnimation(format) || given.has("--gear")))
    return wrong(translated("Only --to glb of a train or a link carries an animation."));
  if (given.has("--gear") && given.has("--link"))
    return wrong(translated("Give --gear or --link, not both."));
  const auto loaded = trainAsked(context, given, stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  const auto& train = std::get<ExportTrain>(loaded);
  const double fineness = std::get<double>(tolerance);
  SolidsChoice choice;
  choice.moves = carriesAnimation(format);
  choice.seconds = std::get<double>(seconds);
  bool isFlawed = false;
  auto scene = given.has("--gear") ? oneGear(context, train, *given.value("--gear"), fineness)
                                   : trainScene(context, train, given, choice, fineness, isFlawed, stop);
  if (auto* error = std::get_if<ExportError>(&scene)) return std::move(*error);
  const auto error =
      writeMesh(std::get<MeshScene>(scene), format, target.path, MeshWriteOptions{target.progress, stop});
  if (error) return meshErrorOf(*error);
  return ExportOutcome{isFlawed};
}

ExportResult writeAssemblyOf(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                             const std::stop_token& stop) {
  const auto tolerance =
      numberWithin(given, "--tolerance", kExportTolerance, kFinestTolerance, kCoarsestTolerance);
  const auto frames = numberWithin(given, "--frames", 24, static_cast<double>(kMinFrames),
                                   static_cast<double>(kMaxAssemblyFrames));
  for (const auto* read : {&tolerance, &frames}) {
    if (const auto* error = std::get_if<UsageError>(read))
      return ExportError{ExportError::Kind::usage, error->message};
  }
  if (target.path == "-")
    return ExportError{ExportError::Kind::usage, translated("--to assembly writes a folder; \"-\" is none.")};
  const auto loaded = trainAsked(context, given, stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  auto made = trainAssembly(std::get<ExportTrain>(loaded), std::get<double>(tolerance),
                            static_cast<std::size_t>(std::get<double>(frames)), stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return context.errorOf(*why);
  const auto error = writeAssembly(std::get<Assembly>(made), target.path, target.mayOverwrite,
                                   MeshWriteOptions{target.progress, stop});
  if (error) return meshErrorOf(*error);
  return ExportOutcome{};
}

constexpr ExportOption kTolerance =
    numberOption("--tolerance", kFinestTolerance, kCoarsestTolerance, "0.002", toTranslate("modules"));
constexpr std::array kSolidOptions = {textOption("--gear"), textOption("--link"), kTolerance};
constexpr std::array kMovingSolidOptions = {
    textOption("--gear"), textOption("--link"),
    numberOption("--animate", kShortestAnimation, kMaxAnimation, {}, "s"), kTolerance};
constexpr std::array kAssemblyOptions = {
    numberOption("--frames", static_cast<double>(kMinFrames), static_cast<double>(kMaxAssemblyFrames), "24",
                 {}, true),
    kTolerance};
constexpr std::array kSolidRefusals = {&kErrorsRefusal, &kGearsRefusal, &kTooLargeRefusal};
constexpr std::string_view kGears = toTranslate("gears");

template <MeshFormat format>
constexpr Exporter solidExporter(std::string_view name, std::string_view title,
                                 ExportFiles files = ExportFiles::file) {
  return {name,
          name,
          title,
          kGears,
          files,
          name,
          format == MeshFormat::glb ? std::span<const ExportOption>(kMovingSolidOptions) : kSolidOptions,
          {},
          ExportNeed::kinematics,
          kSolidRefusals,
          writeSolids<format>};
}

constexpr std::array kSolidExporters = {
    solidExporter<MeshFormat::stl>("stl", "STL"),
    solidExporter<MeshFormat::obj>("obj", "Wavefront (OBJ)", ExportFiles::files),
    solidExporter<MeshFormat::ply>("ply", "PLY"),
    solidExporter<MeshFormat::glb>("glb", toTranslate("GLB, in motion")),
    solidExporter<MeshFormat::threeMf>("3mf", "3MF")};

constexpr std::array kAssemblyExporters = {Exporter{"assembly",
                                                    "assembly",
                                                    toTranslate("Assembly: gears with their poses"),
                                                    toTranslate("gears for a check"),
                                                    ExportFiles::folder,
                                                    {},
                                                    kAssemblyOptions,
                                                    {},
                                                    ExportNeed::kinematics,
                                                    kSolidRefusals,
                                                    writeAssemblyOf}};

}  // namespace

ExportFamily solidFamily() {
  return {toTranslate("Solids"), {}, {}, false, kSolidExporters, ExportPurpose::cad, "png-3d"};
}

ExportFamily assemblyFamily() {
  return {toTranslate("Checks of teeth"), {}, {}, false, kAssemblyExporters, ExportPurpose::cad, "png-3d"};
}

}  // namespace geargraph
