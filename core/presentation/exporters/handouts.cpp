// The mechanism as a page for browsers, or as a package with that page, also with exercises.

#include <array>

#include "core/presentation/export_api/handout_train.h"
#include "core/presentation/export_api/scorm_package.h"
#include "core/presentation/exporters/derivation_export.h"
#include "core/presentation/exporters/exercise_plan.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/handout/handout.h"

namespace geargraph {
namespace {

using AskedExercises = std::optional<HandoutExercises>;

ExportError wrongExercises(std::string message) {
  return {ExportError::Kind::usage, std::move(message)};
}

/// What --exercises and its options ask for; none without it.
std::variant<AskedExercises, ExportError> exercisesFrom(ExportContext& context, const OptionValues& given) {
  if (!given.has("--exercises")) {
    for (const char* option : {"--kinds", "--seed", "--title", "--variants", "--variant"}) {
      if (given.has(option)) return wrongExercises(translated("%1 needs --exercises.", {option}));
    }
    return AskedExercises();
  }
  // By its mark a sheet is that of a document as it is in its file.
  for (const char* option : {"--inputs", "--speed", "--state", "--engage"}) {
    if (given.has(option)) {
      return wrongExercises(
          translated("%1 has no meaning with --exercises, which ask about the document.", {option}));
    }
  }
  if (!context.isFile()) return wrongExercises(translated("--exercises needs a file, not standard input."));
  auto plan = planFrom(given);
  if (auto* error = std::get_if<UsageError>(&plan)) return wrongExercises(std::move(error->message));
  auto& sheet = std::get<SheetPlan>(plan);
  const auto variant = numberFrom<int>(given.value("--variant").value_or("1"));
  if (!variant || *variant < 1 || *variant > sheet.variants)
    return wrongExercises(translated("--variant is a whole number from 1 to that of --variants."));
  const auto read = context.document();
  if (const auto* error = std::get_if<ExportError>(&read)) return *error;
  const Mechanism& mechanism = *std::get<MechanismPtr>(read);
  if (mechanism.n() > kMaxExerciseLinks)
    return ExportError{ExportError::Kind::limit, exercisesTooLarge(), kTooLargeRefusal.code};
  const ExerciseSource source(mechanism);
  auto kinds = kindsFrom(given, source);
  if (auto* error = std::get_if<UsageError>(&kinds)) return wrongExercises(std::move(error->message));
  sheet.kinds = std::get<std::vector<ExerciseKind>>(std::move(kinds));
  if (sheet.kinds.empty()) return wrongExercises(translated("Nothing can be asked about this mechanism."));
  return AskedExercises(handoutExercises(source, sheet, *variant));
}

template <HandoutUse use>
ExportResult writeHandout(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                          const std::stop_token& stop) {
  auto made = exercisesFrom(context, given);
  if (auto* error = std::get_if<ExportError>(&made)) return std::move(*error);
  const auto& exercises = std::get<AskedExercises>(made);
  if (exercises && !given.has("--seed")) {
    context.tell(translated("--seed %1 asks these questions again.", {std::to_string(exercises->plan.seed)}),
                 ExportNote::About::nextTime);
  }
  return writeDerivation(
      context, given, target, stop, [&](const SnapshotPtr& document) -> Expected<std::string> {
        const bool isVaried = exercises && exercises->plan.variants > 1;
        const SnapshotPtr snapshot = isVaried ? analyze(exercises->mechanism, 0, stop) : document;
        if (!snapshot) return std::string();  // out of time
        const MadeHandoutTrain train = handoutTrain(*snapshot, context.folder(), stop);
        for (const std::string& note : train.notes) context.tell(note, ExportNote::About::file);
        Expected<std::string> page = handoutHtml(snapshot, svgDrawings(arrangedLists(*snapshot, stop)),
                                                 train.train, use, exercises, stop);
        if (!page || use == HandoutUse::alone) return page;
        return scormPackage(reportTitle(*snapshot->mechanism), *page);
      });
}

constexpr std::array kHandoutOptions = {textOption("--inputs"),
                                        textOption("--speed"),
                                        flagOption("--exercises"),
                                        textOption("--kinds"),
                                        textOption("--seed"),
                                        textOption("--title"),
                                        numberOption("--variants", 1, kMaxVariants, "1", {}, true),
                                        numberOption("--variant", 1, kMaxVariants, "1", {}, true)};
constexpr std::array kHandoutRefusals = {&kTooLargeRefusal};

constexpr std::array kHandoutExporters = {
    Exporter{"handout",
             "handout",
             toTranslate("Handout, a web page"),
             toTranslate("a page for browsers, with inputs to move"),
             ExportFiles::file,
             "html",
             kHandoutOptions,
             {},
             ExportNeed::nothing,
             kHandoutRefusals,
             writeHandout<HandoutUse::alone>},
    Exporter{"scorm",
             "scorm",
             toTranslate("Handout for learning platforms (SCORM 1.2)"),
             toTranslate("that page as a package for learning platforms (SCORM 1.2)"),
             ExportFiles::file,
             "zip",
             kHandoutOptions,
             {},
             ExportNeed::nothing,
             kHandoutRefusals,
             writeHandout<HandoutUse::learningPlatform>}};

}  // namespace

ExportFamily handoutFamily() {
  return {toTranslate("Handouts"), toTranslate("handouts"), {}, false, kHandoutExporters, ExportPurpose::web};
}

}  // namespace geargraph
