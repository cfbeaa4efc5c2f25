// Transverse profiles of wheels, for laser and wire.

#include <array>
#include <charconv>

#include "core/foundations/base/text_lists.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/dxf/dxf_file.h"
#include "core/presentation/dxf/gear_profile.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/number_options.h"
#include "core/theory/statics/applied_loads.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNoProfile{"no-profile",
                                   toTranslate("A wheel without teeth in one plane has no profile.")};

enum ProfileLayer { cut, bore, tip, pitch, root, center, words };

std::vector<DxfLayer> profileLayers() {
  return {{"PROFILE", 7, false}, {"BORE", 3, false},  {"TIP", 8, true},  {"PITCH", 4, true},
          {"ROOT", 8, true},     {"CENTRE", 1, true}, {"TEXT", 2, false}};
}

/// About six digits, whatever the language.
std::string decimalText(double value) {
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr};
}

/// A wheel about a point: outline, bore or rim, its circles, its centre, and what it is.
void addWheel(DxfFile& file, const TrainGear& gear, const Eigen::Vector2d& at, double deviation) {
  const GearSpec& spec = gear.spec;
  std::vector<ArcVertex> outline = toothOutline(spec, deviation);
  for (ArcVertex& vertex : outline) vertex.at += at;
  file.addPolyline(cut, outline, true);
  if (isRing(spec)) {
    file.addCircle(cut, at, rimDiameter(spec) / 2);
  } else if (spec.bore > 0) {
    file.addCircle(bore, at, spec.bore / 2);
  }
  file.addCircle(tip, at, nominalTipRadius(spec));
  file.addCircle(pitch, at, pitchRadius(spec));
  file.addCircle(root, at, nominalRootRadius(spec));
  const double arm = spec.module;
  file.addLine(center, at - Eigen::Vector2d(arm, 0), at + Eigen::Vector2d(arm, 0));
  file.addLine(center, at - Eigen::Vector2d(0, arm), at + Eigen::Vector2d(0, arm));
  file.addText(words, at + Eigen::Vector2d(-outerRadius(spec), -outerRadius(spec) - 2 * spec.module),
               spec.module,
               gear.name + "  z " + std::to_string(spec.teeth) + "  m " + decimalText(spec.module) + "  x " +
                   decimalText(spec.profileShift));
}

/// The wheels that are asked for; an error where the one that is named has no profile.
std::variant<std::vector<const TrainGear*>, ExportError> wheelsAsked(const ExportContext& context,
                                                                     const ExportTrain& train,
                                                                     const OptionValues& given) {
  std::vector<const TrainGear*> wheels;
  if (const auto name = given.value("--gear")) {
    const TrainGear* const gear = gearNamed(train, *name);
    if (gear == nullptr) {
      return ExportError{
          ExportError::Kind::usage,
          translated("There is no gear \"%1\"; gears are named like 15:tail, 15:head", {*name}) + '.'};
    }
    if (!isDrawnPlane(gear->spec))
      return ExportError{ExportError::Kind::mechanism, translated(kNoProfile.meaning), kNoProfile.code};
    wheels.push_back(gear);
  } else {
    std::vector<std::string> left;
    for (const TrainGear& gear : train.train.gears) {
      if (isDrawnPlane(gear.spec)) {
        wheels.push_back(&gear);
      } else {
        left.push_back(gear.name);
      }
    }
    if (wheels.empty())
      return ExportError{ExportError::Kind::mechanism, translated(kNoProfile.meaning), kNoProfile.code};
    if (!left.empty())
      context.tell(translated("Left out, as they have no teeth in one plane: %1.", {listed(left, 8)}));
  }
  for (const TrainGear* const gear : wheels) {
    const Diagnostics why = specDiagnostics(gear->spec);
    if (!hasErrors(why)) continue;
    context.tell(why);
    return ExportError{ExportError::Kind::mechanism, {}, kGearsRefusal.code};
  }
  return wheels;
}

ExportResult writeProfiles(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                           const std::stop_token& stop) {
  const auto deviation =
      numberWithin(given, "--tolerance", kUsualDeviation, kFinestTolerance, kCoarsestTolerance);
  if (const auto* error = std::get_if<UsageError>(&deviation))
    return ExportError{ExportError::Kind::usage, error->message};
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  const auto loaded = context.train(std::get<Mechanism>(std::move(document)), given.has("--gear"), stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  const auto& train = std::get<ExportTrain>(loaded);
  const auto asked = wheelsAsked(context, train, given);
  if (const auto* error = std::get_if<ExportError>(&asked)) return *error;
  DxfFile file(profileLayers());
  double x = 0;  // the right edge of the wheel before, with a gap
  for (const TrainGear* const gear : std::get<std::vector<const TrainGear*>>(asked)) {
    if (stop.stop_requested()) return outOfTime(translated("the profiles"));
    const double radius = outerRadius(gear->spec);
    const Eigen::Vector2d at = given.has("--gear") ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(x + radius, 0);
    addWheel(file, *gear, at, std::get<double>(deviation));
    x += 2 * radius + 4 * gear->spec.module;
  }
  const auto metres = metresPerUnit(train.mechanism());
  if (auto error = writeExport(file.text(metres ? dxfUnits(metres->toDouble()) : 0), target.path))
    return *std::move(error);
  return ExportOutcome{};
}

constexpr std::array kProfileOptions = {
    textOption("--gear"),
    numberOption("--tolerance", kFinestTolerance, kCoarsestTolerance, "0.0005", toTranslate("modules"))};
constexpr std::array kProfileRefusals = {&kErrorsRefusal, &kGearsRefusal, &kTooLargeRefusal, &kNoProfile};

constexpr std::array kProfileExporters = {Exporter{"dxf",
                                                   "dxf",
                                                   toTranslate("Profiles of wheels (DXF)"),
                                                   toTranslate("profiles of wheels"),
                                                   ExportFiles::file,
                                                   "dxf",
                                                   kProfileOptions,
                                                   {},
                                                   ExportNeed::kinematics,
                                                   kProfileRefusals,
                                                   writeProfiles}};

}  // namespace

ExportFamily profileFamily() {
  return {toTranslate("Cutting profiles"), {}, {}, false, kProfileExporters, ExportPurpose::cad, "png-3d"};
}

}  // namespace geargraph
