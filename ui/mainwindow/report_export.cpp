// File > Export derivation: both methods worked out, as a web page, PDF, LaTeX or Markdown. File > Export
// handout: the same as one page with the train in three dimensions and inputs that move. Sheets of exercises,
// and lessons as pages.

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>
#include <array>

#include "core/presentation/export_api/handout_train.h"
#include "core/presentation/export_api/report_lists.h"
#include "core/presentation/export_api/scorm_package.h"
#include "core/presentation/lesson_pages/lesson_files.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/teaching/lessons/course.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/export_source.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/reading/derivation_panel.h"
#include "ui/settings/settings.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// The handouts that were written without asking where.
const QString kHandoutsKey = QStringLiteral("export/handouts");
constexpr qsizetype kMostHandouts = 200;

ReportForm formOf(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == QLatin1String("tex")) return ReportForm::latex;
  return suffix == QLatin1String("md") ? ReportForm::markdown : ReportForm::html;
}

/// A sheet about the document as it is shown, the same for everyone; without kinds a question of every kind
/// that the mechanism gives, as `geargraph-cli exercises make` asks them; none where it gives none.
std::optional<HandoutExercises> exercisesFor(const Mechanism& mechanism, SheetPlan plan) {
  if (mechanism.n() > kMaxExerciseLinks) return std::nullopt;
  const ExerciseSource source(mechanism);
  if (plan.kinds.empty()) plan.kinds = offeredKinds(source);
  if (plan.kinds.empty()) return std::nullopt;
  plan.variants = 1;
  return handoutExercises(source, plan, 1);
}

bool isPackage(const QString& path) {
  return QFileInfo(path).suffix().toLower() == QLatin1String("zip");
}

}  // namespace

QString WindowExports::whyNoDerivation() const {
  return geargraph::whyNoDerivation(*m_workbench.document().mechanism());
}

void WindowExports::chooseAndExportDerivation() {
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export derivation"), name + QStringLiteral(".html"),
                                   tr("Web page (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".html");
  exportDerivation(path);
}

/// The drawings that the window arranges, as it shows them; what keeps them from being exported is told by
/// rejected().
std::optional<ReportLists> WindowExports::shownLists() {
  if (!m_workbench.analysis().isComplete()) {
    emit rejected(tr("The solution is still being worked out. Try again in a moment."));
    return std::nullopt;
  }
  ReportLists lists;
  for (DrawingView* each : m_views.drawings) {
    if (each->objectName() == QLatin1String("levers")) continue;  // drawn for the export, whatever it shows
    for (const ReportDrawing drawing : kArrangedDrawings) {
      if (each->objectName() == QLatin1String(reportDrawingName(drawing))) lists[drawing] = each->picture();
    }
    const QString why = each->whyNoPicture();
    if (why.isEmpty()) continue;
    emit rejected(why);
    return std::nullopt;
  }
  return lists;
}

void WindowExports::exportDerivation(const QString& path) {
  const std::optional<ReportLists> shown = shownLists();
  if (!shown) return;
  const SnapshotPtr snapshot = m_workbench.analysis().snapshot();
  const auto run = [=, arranged = *shown](const ExportJobs::Progress&, const std::stop_token& stop) {
    Report report = derivationReport(snapshot, stop);
    const ReportLists lists = withLevers(arranged, *snapshot, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (QFileInfo(path).suffix().toLower() == QLatin1String("pdf")) {
      const Expected<std::string> pages = reportPdf(std::move(report), lists);
      return pages ? writingError(path, *pages) : QString::fromStdString(pages.error().front().message);
    }
    return writingError(path, reportText(report, formOf(path), [&] { return lists; }));
  };
  m_jobs->add({path, false, run});
}

void WindowExports::chooseAndExportHandout() {
  const QString plain = tr("Web page (*.html)");
  const QString asking = tr("Web page with exercises (*.html)");
  const QString package = tr("Package for learning platforms, SCORM 1.2 (*.zip)");
  const QString askingPackage = tr("Package with exercises, SCORM 1.2 (*.zip)");
  QString chosen = plain;
  const QString path = handoutPath({plain, asking, package, askingPackage}, chosen);
  if (path.isEmpty()) return;
  const bool asks = chosen == asking || chosen == askingPackage;
  writeHandout(path, asks ? std::optional(everyKind()) : std::nullopt);
}

void WindowExports::chooseAndExportHandoutAsking(const SheetPlan& plan) {
  QString chosen = tr("Web page (*.html)");
  const QString path = handoutPath({chosen, tr("Package for learning platforms, SCORM 1.2 (*.zip)")}, chosen);
  if (!path.isEmpty()) exportHandoutAsking(path, plan);
}

/// Where the user wants it, with the suffix of the form that was chosen where none was typed.
QString WindowExports::handoutPath(const QStringList& forms, QString& chosen) const {
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export handout"), name + QStringLiteral("-handout"),
                                   forms.join(QStringLiteral(";;")), &chosen);
  if (path.isEmpty() || !QFileInfo(path).suffix().isEmpty()) return path;
  return path + (chosen.contains(QLatin1String("*.zip")) ? QStringLiteral(".zip") : QStringLiteral(".html"));
}

SheetPlan WindowExports::everyKind() {
  SheetPlan plan;
  plan.title = tr("Exercises").toStdString();
  return plan;
}

void WindowExports::exportHandout(const QString& path) {
  writeHandout(path, std::nullopt);
}

void WindowExports::exportHandoutNow() {
  const ExportedDocument document = exported();
  const bool hasFolder = !document.file.isEmpty() && !document.file.startsWith(QLatin1Char(':'));
  const QString folder = hasFolder ? QFileInfo(document.file).absolutePath()
                                   : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString stem = document.stem() + QStringLiteral("-handout");
  const QStringList own = savedSetting(kHandoutsKey).toStringList();
  QString path = QDir(folder).filePath(stem + QStringLiteral(".html"));
  for (int number = 2; QFileInfo::exists(path) && !own.contains(path); ++number)
    path = QDir(folder).filePath(QStringLiteral("%1-%2.html").arg(stem).arg(number));
  if (!QDir().mkpath(folder)) return emit rejected(tr("The folder %1 could not be made.").arg(folder));
  saveSetting(kHandoutsKey, QStringList(QStringList{path} + own).mid(0, kMostHandouts));
  exportHandout(path);
}

void WindowExports::exportHandoutAsking(const QString& path, const SheetPlan& plan) {
  writeHandout(path, plan);
}

void WindowExports::writeHandout(const QString& path, const std::optional<SheetPlan>& plan) {
  const std::optional<ReportLists> lists = shownLists();
  if (!lists) return;
  const SnapshotPtr snapshot = m_workbench.analysis().snapshot();
  const auto mechanism = m_workbench.document().mechanism();
  const std::filesystem::path folder =
      QFile::encodeName(QFileInfo(m_files.source()).absolutePath()).toStdString();
  const auto run = [=, lists = *lists](const ExportJobs::Progress&, const std::stop_token& stop) {
    const MadeHandoutTrain made = handoutTrain(*snapshot, folder, stop);
    std::optional<HandoutExercises> exercises;
    if (plan) {
      exercises = exercisesFor(*mechanism, *plan);
      if (!exercises) return tr("Nothing can be asked about this mechanism: export it without exercises.");
    }
    const HandoutUse use = isPackage(path) ? HandoutUse::learningPlatform : HandoutUse::alone;
    const Expected<std::string> page =
        handoutHtml(snapshot, svgDrawings(lists), made.train, use, exercises, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (!page) return QString::fromStdString(page.error().front().message);
    return writingError(path, isPackage(path) ? scormPackage(reportTitle(*mechanism), *page) : *page);
  };
  m_jobs->add({path, false, run});
}

void WindowExports::chooseAndExportSheets(const SheetRequest& request) {
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  const QString where =
      QFileDialog::getExistingDirectory(m_window, tr("Folder in which the sheets' folder is made"));
  if (where.isEmpty()) return;
  exportSheets(QDir(where).filePath(tr("%1 exercises %2").arg(name).arg(request.plan.seed)), request);
}

void WindowExports::exportSheets(const QString& folder, const SheetRequest& request) {
  if (QFileInfo::exists(folder)) {
    emit rejected(tr("\"%1\" is there already: no sheet was written.").arg(QFileInfo(folder).fileName()));
    return;
  }
  const auto mechanism = m_workbench.document().mechanism();
  SheetRequest asked = request;
  asked.folder = QFile::encodeName(QFileInfo(m_files.source()).absolutePath()).toStdString();
  const auto run = [=](const ExportJobs::Progress& progress, const std::stop_token& stop) {
    const ExerciseSource source(*mechanism);
    const auto files = sheetFiles(
        source, asked, [&](int variants) { progress(variants, request.plan.variants); }, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (!files) return QString::fromStdString(files.error().front().message);
    const auto error = writeFolder(QFile::encodeName(folder).toStdString(), *files, {false, stop, {}});
    return error ? QString::fromStdString(error->message) : QString();
  };
  m_jobs->add({folder, true, run});
}

void WindowExports::chooseAndExportLessons() {
  const QString where =
      QFileDialog::getExistingDirectory(m_window, tr("Folder in which the lessons' folder is made"));
  if (!where.isEmpty()) exportLessons(QDir(where).filePath(tr("GearGraph lessons")));
}

void WindowExports::exportLessons(const QString& folder) {
  if (QFileInfo::exists(folder)) {
    emit rejected(tr("\"%1\" is there already: no lesson was written.").arg(QFileInfo(folder).fileName()));
    return;
  }
  const auto run = [=](const ExportJobs::Progress& /*progress*/, const std::stop_token& stop) {
    constexpr std::array kForms = {LessonFileForm::html, LessonFileForm::scorm};
    const auto files = lessonFiles(course(), kForms, bundledExample, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (!files) return QString::fromStdString(files.error().front().message);
    const auto error = writeFolder(QFile::encodeName(folder).toStdString(), *files, {false, stop, {}});
    return error ? QString::fromStdString(error->message) : QString();
  };
  m_jobs->add({folder, true, run});
}

}  // namespace geargraph
