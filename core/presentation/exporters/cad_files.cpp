// Wheels, bodies and whole trains for CAD.

#include <array>

#include "core/foundations/base/readable.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/number_options.h"
#include "core/presentation/step/step_model.h"
#include "core/presentation/step/step_process.h"

namespace geargraph {
namespace {

constexpr double kUsualStepDeviation = 1e-3;  // modules
constexpr double kFinestStepDeviation = 1e-5;

constexpr ExportRefusal kNoStep{"no-step",
                                toTranslate("The program geargraph-step, which writes STEP files, is not "
                                            "installed; it is in the package of that name.")};
constexpr ExportRefusal kStepFailed{"step-failed",
                                    toTranslate("OpenCASCADE could not make the solids or write the file.")};

std::string missingWriter() {
  if (!stepWriter().empty()) return {};
  return translated(
      "The program geargraph-step, which writes STEP files, is not installed; it is in the package of that "
      "name.");
}

std::array<float, 3> colourOf(int number) {
  const Color color = linkColor(number);
  constexpr float kFull = 255;
  return {static_cast<float>(color.red) / kFull, static_cast<float>(color.green) / kFull,
          static_cast<float>(color.blue) / kFull};
}

ExportError errorOf(const ExportContext& context, const StepFailure& why) {
  switch (why.kind) {
    case StepFailure::Kind::stopped:
      return outOfTime(translated("the solids"));
    case StepFailure::Kind::gears:
      context.tell(why.diagnostics);
      return {ExportError::Kind::mechanism, {}, kGearsRefusal.code};
    case StepFailure::Kind::nothing:
      return {ExportError::Kind::mechanism, translated("There are no solids to write."), kGearsRefusal.code};
    case StepFailure::Kind::tooLarge:
      break;
  }
  return {ExportError::Kind::limit,
          translated("More than %1 faces are too many for a STEP file; --gear and --link export a part.",
                     {std::to_string(kMaxStepFaces)}),
          kTooLargeRefusal.code};
}

ExportError errorOf(const StepProcessError& why) {
  using Kind = StepProcessError::Kind;
  if (why.kind == Kind::stopped) return outOfTime(translated("the file"));
  if (why.kind == Kind::limit) return {ExportError::Kind::limit, why.message, kTooLargeRefusal.code};
  return {ExportError::Kind::limit, why.message, why.kind == Kind::missing ? kNoStep.code : kStepFailed.code};
}

/// What the options ask for, or what is wrong with them.
std::variant<StepChoice, ExportError> choiceOf(const ExportTrain& train, const OptionValues& given,
                                               double deviation) {
  StepChoice choice;
  choice.deviation = deviation;
  const auto wrong = [](std::string message) {
    return ExportError{ExportError::Kind::usage, std::move(message)};
  };
  if (const auto name = given.value("--gear")) {
    choice.gear = gearNamed(train, *name);
    if (choice.gear == nullptr)
      return wrong(translated("There is no gear \"%1\"; gears are named like 15:tail, 15:head", {*name}) +
                   '.');
  }
  if (const auto name = given.value("--link")) {
    choice.link = linkNamed(train.mechanism(), *name);
    if (!choice.link) return wrong(translated("There is no link \"%1\" with solids", {*name}) + '.');
  }
  return choice;
}

ExportResult writeStep(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                       const std::stop_token& stop) {
  const auto wrong = [](std::string message) {
    return ExportError{ExportError::Kind::usage, std::move(message)};
  };
  const auto read =
      numberWithin(given, "--tolerance", kUsualStepDeviation, kFinestStepDeviation, kCoarsestTolerance);
  if (const auto* error = std::get_if<UsageError>(&read)) return wrong(error->message);
  if (given.has("--gear") && given.has("--link"))
    return wrong(translated("Give --gear or --link, not both."));
  const auto writer = stepWriter();
  if (writer.empty()) return ExportError{ExportError::Kind::limit, missingWriter(), kNoStep.code};
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  const auto loaded = context.train(std::get<Mechanism>(std::move(document)),
                                    given.has("--gear") || given.has("--link"), stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  const auto& train = std::get<ExportTrain>(loaded);
  const double deviation = std::get<double>(read);
  const auto choice = choiceOf(train, given, deviation);
  if (const auto* error = std::get_if<ExportError>(&choice)) return *error;
  const double unit = 1000 * metresPerUnit(train.mechanism().unit);
  auto made = stepModel(train.mechanism(), train.train, context.stem(), unit, colourOf,
                        std::get<StepChoice>(choice), stop);
  if (const auto* why = std::get_if<StepFailure>(&made)) return errorOf(context, *why);
  auto& model = std::get<StepModel>(made);
  model.assembly.program = "GearGraph";
  const auto file = stepBytes(writer, model.assembly, {}, target.progress, stop);
  if (const auto* why = std::get_if<StepProcessError>(&file)) return errorOf(*why);
  const auto& step = std::get<StepBytes>(file);
  if (auto error = writeExport(step.bytes, target.path)) return *std::move(error);
  if (model.deviation > deviation) {
    context.tell(translated("Teeth of a worm's wheel are within %1 modules instead of %2 (--tolerance).",
                            {readableNumber(model.deviation), readableNumber(deviation)}));
  }
  if (step.ununited > 0) {
    context.tell(translated("Of %1 part(s) the solids could not be united; they overlap.",
                            {std::to_string(step.ununited)}));
  }
  context.tell(translated("%1 parts, %2 solids, teeth within %3 modules of their exact form.",
                          {std::to_string(model.assembly.parts.size()), std::to_string(step.solids),
                           readableNumber(std::max(deviation, model.deviation))}));
  return ExportOutcome{};
}

constexpr std::array kStepOptions = {
    textOption("--gear"), textOption("--link"),
    numberOption("--tolerance", kFinestStepDeviation, kCoarsestTolerance, "0.001", toTranslate("modules"))};
constexpr std::array kStepRefusals = {&kErrorsRefusal, &kGearsRefusal, &kTooLargeRefusal, &kNoStep,
                                      &kStepFailed};

constexpr std::array kStepExporters = {Exporter{"step",
                                                "step",
                                                toTranslate("STEP (AP214), for CAD"),
                                                toTranslate("an assembly for CAD"),
                                                ExportFiles::file,
                                                "step",
                                                kStepOptions,
                                                {},
                                                ExportNeed::kinematics,
                                                kStepRefusals,
                                                writeStep,
                                                missingWriter}};

}  // namespace

ExportFamily cadFamily() {
  return {toTranslate("CAD"), {}, {}, false, kStepExporters};
}

}  // namespace geargraph
