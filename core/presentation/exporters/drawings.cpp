// Drawings as pictures.

#include <array>

#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/drawing/captions.h"
#include "core/presentation/export_api/named_drawings.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/view3d_options.h"
#include "core/teaching/derivation/solved_statics.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNoPower{
    "no-power", toTranslate("No power flows, or what there is of loads and motion does not determine it.")};

std::variant<DrawingPicture, UsageError> drawingOptions(const OptionValues& given, PictureForm form) {
  DrawingPicture picture;
  picture.form = form;
  picture.style.theme = given.has("--dark") ? Theme::dark : Theme::light;
  picture.style.transparent = given.has("--transparent");
  if (const auto text = given.value("--size")) {
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

/// Why no power can be drawn; what was found out about the torques is told.
ExportError whyNoDrawnPower(const ExportContext& context, const std::optional<StaticsReport>& report) {
  const auto because = [&](const char* sentence) {
    if (report) context.tell(report->diagnostics);
    return ExportError{ExportError::Kind::mechanism,
                       translated(sentence) + ' ' + translated("Nothing was written."), kNoPower.code};
  };
  if (!report) return because(toTranslate("--power needs a mechanism without errors."));
  if (report->loads.empty())
    return because(toTranslate(
        "--power needs loads: this document has none, so that no power flows. Add \"loads\" to it."));
  if (!report->isSolved || !report->lossless.isBalanced())
    return because(toTranslate("--power needs balances that hold the loads."));
  if (!report->isAnswered()) return because(toTranslate("With these losses no torques are known."));
  if (!report->motion) return because(toTranslate("--power needs a motion: the speeds are not determined."));
  return because(toTranslate("No power flows: the loads and what holds them do no work in this motion."));
}

/// The power of the document's loads, of no drawing without --power.
std::variant<std::optional<DrawnPower>, ExportError> drawnPower(const ExportContext& context,
                                                                const SnapshotPtr& snapshot,
                                                                const OptionValues& given,
                                                                const std::stop_token& stop) {
  const auto word = given.value("--power");
  if (!word) return std::optional<DrawnPower>();
  const auto observer = observerOf(*snapshot->mechanism, *word);
  if (!observer) {
    return ExportError{ExportError::Kind::usage,
                       translated("--power is ground or the label of a link, not \"%1\".", {*word})};
  }
  const SolvedStaticsPtr solved = solvedStatics(snapshot, given.value("--state"), false, stop);
  if (!solved) return outOfTime(translated("the torques"));
  const SolvedStatics& statics = *solved;
  DrawnPower power;
  if (statics.report) {
    const auto& kinematics = *statics.snapshot->kinematics;
    power.picture = powerPicture(*snapshot->mechanism, *kinematics.model, kinematics.placement(),
                                 *statics.report, *observer);
    power.torques = shownTorques(*snapshot->mechanism, *statics.report);
  }
  if (!power.picture.isEmpty()) return std::optional(std::move(power));
  return whyNoDrawnPower(context, statics.report);
}

/// The drawing that `--view` names; an error names those that there are.
std::variant<const NamedDrawing*, ExportError> drawingAsked(const OptionValues& given, PictureForm form) {
  const std::string view = given.value("--view").value_or("");
  const NamedDrawing* drawing = drawingNamed(view);
  if (drawing != nullptr) return drawing;
  if (view == "3d")
    return ExportError{ExportError::Kind::usage,
                       translated("--view 3d is made of pixels: it needs --to png.")};
  const std::string solid = form == PictureForm::png ? ", 3d" : "";
  return ExportError{ExportError::Kind::usage,
                     translated("%1 needs --view: one of %2.",
                                {"--to " + std::string(pictureFormName(form)), drawingNames() + solid})};
}

template <PictureForm form>
ExportResult writeDrawing(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                          const std::stop_token& stop) {
  const auto asked = drawingAsked(given, form);
  if (const auto* error = std::get_if<ExportError>(&asked)) return *error;
  const NamedDrawing& drawing = *std::get<const NamedDrawing*>(asked);
  auto options = drawingOptions(given, form);
  if (auto* error = std::get_if<UsageError>(&options))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  auto& picture = std::get<DrawingPicture>(options);
  const auto analyzed = context.live(given, stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  picture.title = snapshot->mechanism->name;
  if (given.has("--power") && !drawing.showsPower)
    return ExportError{ExportError::Kind::usage,
                       translated("--power is drawn in the digraph and in the schematic.")};
  if (given.has("--captions") && !drawing.captionSize)
    return ExportError{ExportError::Kind::usage,
                       translated("--captions are written in the digraph, the T–T graph and the schematic.")};
  const auto power = drawnPower(context, snapshot, given, stop);
  if (const auto* error = std::get_if<ExportError>(&power)) return *error;
  const auto& bands = std::get<std::optional<DrawnPower>>(power);
  DisplayList drawn = drawing.draw(*snapshot, bands ? &*bands : nullptr, stop);
  if (given.has("--captions") && !stop.stop_requested())
    drawn = withCaptions(std::move(drawn), *snapshot->mechanism, *drawing.captionSize);
  if (stop.stop_requested()) return outOfTime(translated("the drawing"));
  const Expected<std::string> bytes = pictureOf(drawn, picture);
  if (stop.stop_requested()) return outOfTime(translated("the picture"));
  if (!bytes)
    return ExportError{ExportError::Kind::limit, bytes.error().front().message, kGraphicsRefusal.code};
  if (auto error = writeExport(*bytes, target.path)) return *std::move(error);
  return ExportOutcome{hasErrors(snapshot->diagnostics)};
}

std::vector<std::string> namesOfDrawings() {
  std::vector<std::string> names;
  for (const NamedDrawing& drawing : drawings()) names.emplace_back(drawing.name);
  return names;
}

constexpr std::array kDrawingOptions = {choiceOption("--view", namesOfDrawings, {}, true),
                                        textOption("--size"),
                                        flagOption("--dark"),
                                        flagOption("--transparent"),
                                        flagOption("--captions"),
                                        textOption("--power")};
constexpr std::array kDrawingRefusals = {&kNoPower, &kGraphicsRefusal};
constexpr std::string_view kAPicture = toTranslate("a picture");

template <PictureForm form>
constexpr Exporter drawingExporter(std::string_view id, std::string_view name, std::string_view title) {
  return {id,
          name,
          title,
          kAPicture,
          ExportFiles::file,
          name,
          kDrawingOptions,
          {},
          ExportNeed::nothing,
          kDrawingRefusals,
          writeDrawing<form>};
}

constexpr std::array kDrawingExporters = {
    drawingExporter<PictureForm::svg>("svg", "svg", toTranslate("SVG, lines and text")),
    drawingExporter<PictureForm::png>("png", "png", toTranslate("PNG, pixels")),
    drawingExporter<PictureForm::pdf>("pdf-drawing", "pdf", toTranslate("PDF, lines and text"))};

}  // namespace

ExportFamily drawingFamily() {
  static const std::string how = "--view " + drawingNames();
  return {toTranslate("Drawings"), toTranslate("drawings"), how,  true,
          kDrawingExporters,       ExportPurpose::print,    "png"};
}

}  // namespace geargraph
