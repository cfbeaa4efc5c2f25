// Parts of a train for a 3D printer.

#include <array>

#include "core/foundations/files/folder.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/number_options.h"
#include "core/presentation/print_kit/kit_page.h"
#include "core/presentation/print_kit/kit_poses.h"
#include "core/presentation/print_kit/print_kit.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNoKit{"no-kit", toTranslate("A part of the mechanism has no form that prints.")};
constexpr ExportRefusal kKitOverlap{"kit-overlap", toTranslate("Printed parts would overlap.")};
constexpr ExportRefusal kTooLargeForBed{"bed", toTranslate("A part does not fit the plate.")};

constexpr double kLeastBed = 50;
constexpr double kMaxBed = 2000;

/// "220x220", or one number for a square.
std::optional<Eigen::Vector2d> bedFrom(std::string_view text) {
  const std::size_t by = text.find('x');
  const auto x = numberFrom<double>(text.substr(0, by));
  const auto y = by == std::string_view::npos ? x : numberFrom<double>(text.substr(by + 1));
  const auto isFine = [](const std::optional<double>& side) {
    return side && *side >= kLeastBed && *side <= kMaxBed;
  };
  if (!isFine(x) || !isFine(y)) return std::nullopt;
  return Eigen::Vector2d(*x, *y);
}

std::variant<KitOptions, UsageError> kitOptions(const OptionValues& given) {
  KitOptions options;
  struct Length {
    std::string_view option;
    double* value;
    double least, most;
  };
  for (const Length& each :
       {Length{"--play", &options.play, 0, 1}, Length{"--clearance", &options.bore, 0, 2},
        Length{"--chamfer", &options.chamfer, 0, 1}, Length{"--scale", &options.scale, 0.01, 100}}) {
    const auto read = numberWithin(given, each.option, *each.value, each.least, each.most);
    if (const auto* error = std::get_if<UsageError>(&read)) return *error;
    *each.value = std::get<double>(read);
  }
  if (const auto text = given.value("--bed")) {
    const auto bed = bedFrom(*text);
    if (!bed) {
      return UsageError{translated(
          "--bed is a width and a depth in mm from %1 to %2, like 220x220.",
          {std::to_string(static_cast<int>(kLeastBed)), std::to_string(static_cast<int>(kMaxBed))})};
    }
    options.bedX = bed->x();
    options.bedY = bed->y();
  }
  return options;
}

ExportError kitErrorOf(const ExportContext& context, const KitFailure& why) {
  using Kind = KitFailure::Kind;
  switch (why.kind) {
    case Kind::stopped:
      return outOfTime(translated("the print kit"));
    case Kind::gears:
      context.tell(why.diagnostics);
      return {ExportError::Kind::mechanism, {}, kGearsRefusal.code};
    case Kind::layout:
      return {ExportError::Kind::mechanism, why.message, kNoKit.code};
    case Kind::overlap:
      return {ExportError::Kind::mechanism, why.message, kKitOverlap.code};
    case Kind::bed:
      break;
  }
  return {ExportError::Kind::limit, why.message, kTooLargeForBed.code};
}

Float3 kitColour(int number) {
  const Color color = linkColor(number);
  return {static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
          static_cast<float>(color.blue) / 255};
}

ExportResult writeKit(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                      const std::stop_token& stop) {
  const auto options = kitOptions(given);
  if (const auto* error = std::get_if<UsageError>(&options))
    return ExportError{ExportError::Kind::usage, error->message};
  if (target.path == "-")
    return ExportError{ExportError::Kind::usage, translated("--to kit writes a folder; \"-\" is none.")};
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  const auto loaded = context.train(std::get<Mechanism>(std::move(document)), false, stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  const auto& train = std::get<ExportTrain>(loaded);
  const DerivedGeometry& geometry = *train.snapshot->geometry;
  const auto arrangement = geometry.arrangement(stop);
  if (!arrangement) return outOfTime(translated("the gear train"));
  const double unit = 1000 * metresPerUnit(train.mechanism().unit);
  const std::vector<KitPose> poses = kitPoses(train.mechanism(), train.placed().kinematics, train.motions);
  auto made = printKit(train.mechanism(), geometry.placement(), train.train, *arrangement, unit, poses,
                       std::get<KitOptions>(options), stop);
  if (const auto* why = std::get_if<KitFailure>(&made)) return kitErrorOf(context, *why);
  const auto& kit = std::get<PrintKit>(made);
  auto files = kitFiles(kit, train.mechanism(), train.train, kitColour, stop);
  if (const auto* error = std::get_if<MeshFileError>(&files)) return meshErrorOf(*error);
  const auto error =
      writeFolder(target.path, std::get<FolderFiles>(files), {target.mayOverwrite, stop, target.progress});
  if (error) {
    return error->isStopped ? outOfTime(translated("the folder"))
                            : ExportError{ExportError::Kind::file, error->message};
  }
  for (const std::string& note : kit.notes) context.tell(note);
  context.tell(translated("%1 parts on %2 plate(s).",
                          {std::to_string(kit.parts.size()), std::to_string(kit.plates.size())}));
  return ExportOutcome{};
}

constexpr std::array kKitOptions = {
    textOption("--bed", "220x220"), numberOption("--play", 0, 1, "0.15", "mm"),
    numberOption("--clearance", 0, 2, "0.2", "mm"), numberOption("--chamfer", 0, 1, "0.4", "mm"),
    numberOption("--scale", 0.01, 100, "1")};
constexpr std::array kKitRefusals = {&kErrorsRefusal, &kGearsRefusal, &kTooLargeRefusal,
                                     &kNoKit,         &kKitOverlap,   &kTooLargeForBed};

constexpr std::array kKitExporters = {Exporter{"kit",
                                               "kit",
                                               toTranslate("Print kit: parts for a 3D printer"),
                                               toTranslate("parts for a 3D printer, with their assembly"),
                                               ExportFiles::folder,
                                               {},
                                               kKitOptions,
                                               {},
                                               ExportNeed::kinematics,
                                               kKitRefusals,
                                               writeKit}};

}  // namespace

ExportFamily kitFamily() {
  return {toTranslate("Print kits"), {}, {}, false, kKitExporters, ExportPurpose::cad, "png-3d"};
}

}  // namespace geargraph
