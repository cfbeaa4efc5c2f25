// `export FILE --to svg/pdf/png --view NAME -o OUT`: a drawing as a picture.

#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/element_words.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/file.h"
#include "core/presentation/results/named_drawings.h"
#include "core/presentation/results/solved_statics.h"

namespace geargraph::cli {
namespace {

std::variant<DrawingPicture, UsageError> drawingOptions(const Arguments& arguments, PictureForm form) {
  DrawingPicture picture;
  picture.form = form;
  picture.style.theme = arguments.has("--dark") ? Theme::dark : Theme::light;
  picture.style.transparent = arguments.has("--transparent");
  if (const auto text = arguments.value("--size")) {
    const auto size = pictureSize(*text, kMaxDrawingPixels);
    if (!size) return UsageError{wrongSize(*text, kMaxDrawingPixels)};
    picture.style.size = SheetStyle::Size{size->first, size->second};
  }
  return picture;
}

/// `--power ground` or a link: its ordinal.
std::optional<int> observerOf(const Mechanism& mechanism, const std::string& word) {
  if (word == "ground") return 0;
  const auto link = linkNamed(mechanism, word);
  return link ? std::optional(int{*link}) : std::nullopt;
}

/// Why no power can be drawn: what was found about the torques, and a sentence.
std::string whyNoPower(const std::string& file, const std::optional<StaticsReport>& report) {
  const auto all = [&](const char* sentence) {
    const std::string lines = report ? diagnosticLines(file, report->diagnostics) : std::string();
    return lines + "geargraph-cli: " + translated(sentence) + ' ' + translated("Nothing was written.") + '\n';
  };
  if (!report) return all(toTranslate("--power needs a mechanism without errors."));
  if (report->loads.empty())
    return all(toTranslate(
        "--power needs loads: this document has none, so that no power flows. Add \"loads\" to it."));
  if (!report->isSolved || !report->lossless.isBalanced())
    return all(toTranslate("--power needs balances that hold the loads."));
  if (!report->isAnswered()) return all(toTranslate("With these losses no torques are known."));
  if (!report->motion) return all(toTranslate("--power needs a motion: the speeds are not determined."));
  return all(toTranslate("No power flows: the loads and what holds them do no work in this motion."));
}

/// The power of the document's loads, of no drawing without --power; the exit status where there is none.
std::variant<std::optional<DrawnPower>, int> powerOf(const SnapshotPtr& snapshot,
                                                     const Arguments& arguments) {
  const auto word = arguments.value("--power");
  if (!word) return std::optional<DrawnPower>();
  const auto observer = observerOf(*snapshot->mechanism, *word);
  if (!observer)
    return wrongUsage(kExport, translated("--power is ground or the label of a link, not \"%1\".", {*word}));
  const SolvedStaticsPtr solved = solvedStatics(snapshot, arguments.value("--state"), false, arguments.stop);
  if (!solved) return outOfTime(arguments, translated("the torques"));
  const SolvedStatics& statics = *solved;
  DrawnPower power;
  if (statics.report) {
    const auto& kinematics = *statics.snapshot->kinematics;
    power.picture = powerPicture(*snapshot->mechanism, *kinematics.model, kinematics.placement(),
                                 *statics.report, *observer);
    power.torques = shownTorques(*snapshot->mechanism, *statics.report);
  }
  if (!power.picture.isEmpty()) return std::optional(std::move(power));
  std::cerr << whyNoPower(arguments.files.front(), statics.report);
  return kMechanismErrors;
}

}  // namespace

int exportDrawing(const Arguments& arguments, PictureForm form) {
  const std::string view = arguments.value("--view").value_or("");
  const std::string name(pictureFormName(form));
  const NamedDrawing* drawing = drawingNamed(view);
  if (drawing == nullptr) {
    if (view == "3d")
      return wrongUsage(kExport, translated("--view 3d is made of pixels: it needs --to png."));
    const std::string solid = form == PictureForm::png ? ", 3d" : "";
    return wrongUsage(kExport,
                      translated("%1 needs --view: one of %2.", {"--to " + name, drawingNames() + solid}));
  }
  auto options = drawingOptions(arguments, form);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kExport, error->message);
  auto& picture = std::get<DrawingPicture>(options);
  const auto analyzed = analyzeEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  picture.title = snapshot->mechanism->name;
  if (arguments.has("--power") && !drawing->showsPower)
    return wrongUsage(kExport, translated("--power is drawn in the digraph and in the schematic."));
  const auto power = powerOf(snapshot, arguments);
  if (const int* status = std::get_if<int>(&power)) return *status;
  const auto& bands = std::get<std::optional<DrawnPower>>(power);
  const DisplayList drawn = drawing->draw(*snapshot, bands ? &*bands : nullptr, arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the drawing"));
  const Expected<std::string> bytes = pictureOf(drawn, picture);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the picture"));
  if (!bytes) {
    std::cerr << "geargraph-cli: " << bytes.error().front().message << '\n';
    return kResourceLimit;
  }
  const int written = writePicture(*bytes, *arguments.value("-o"));
  if (written != kFine) return written;
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
