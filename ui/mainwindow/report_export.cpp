// File > Export derivation: both methods worked out, as a web page, PDF, LaTeX or Markdown. File > Export
// handout: the same as one page with the train in three dimensions and inputs that move.

#include <QFileDialog>
#include <QFileInfo>

#include "core/foundations/files/file.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/pages/report_pdf.h"
#include "core/presentation/report/report.h"
#include "core/presentation/results/handout_train.h"
#include "ui/canvas/drawing_view.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/schematic/schematic_view.h"
#include "ui/workbench/workbench.h"

namespace geargraph::inline mainwindow {
namespace {

ReportForm formOf(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == QLatin1String("tex")) return ReportForm::latex;
  return suffix == QLatin1String("md") ? ReportForm::markdown : ReportForm::html;
}

ReportDrawings drawingsOf(const ReportLists& lists) {
  const SheetLook look;
  return {svgOf(lists.schematic, look), svgOf(lists.digraph, look), svgOf(lists.ttGraph, look)};
}

/// Why the file could not be written; empty where it was.
QString writingError(const QString& path, const std::string& bytes) {
  const auto error = writeFile(QFile::encodeName(path).toStdString(), bytes);
  return error ? QString::fromStdString(error->message) : QString();
}

/// A question of every kind that the mechanism gives, as `geargraph-cli exercises make` asks them; none where
/// it gives none.
std::optional<HandoutExercises> exercisesFor(const Mechanism& mechanism) {
  if (mechanism.n() > kMostExerciseLinks) return std::nullopt;
  const ExerciseSource source(mechanism);
  SheetPlan plan;
  plan.title = "Exercises";
  plan.kinds = offeredKinds(source);
  if (plan.kinds.empty()) return std::nullopt;
  return handoutExercises(source, plan, 1);
}

}  // namespace

QString WindowExports::whyNoDerivation() const {
  if (m_workbench.document().mechanism()->n() == 0)
    return tr("There is nothing drawn to derive anything for.");
  if (m_workbench.document().mechanism()->n() <= kMostReportLinks) return {};
  return tr("A derivation of more than %1 links is not written: it would be too long to read.")
      .arg(kMostReportLinks);
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

/// The drawings as the window shows them; what keeps them from being exported is told by refused().
std::optional<ReportLists> WindowExports::shownLists() {
  if (!m_workbench.analysis().isComplete()) {
    emit refused(tr("The solution is still being worked out. Try again in a moment."));
    return std::nullopt;
  }
  ReportLists lists;
  for (DrawingView* each : m_views.drawings) {
    if (each->objectName() == QLatin1String("schematic")) lists.schematic = each->picture();
    if (each->objectName() == QLatin1String("digraph")) lists.digraph = each->picture();
    if (each->objectName() == QLatin1String("ttgraph")) lists.ttGraph = each->picture();
    const QString why = each->whyNoPicture();
    if (why.isEmpty()) continue;
    emit refused(why);
    return std::nullopt;
  }
  return lists;
}

void WindowExports::exportDerivation(const QString& path) {
  const std::optional<ReportLists> shown = shownLists();
  if (!shown) return;
  const ReportLists& lists = *shown;
  const SnapshotPtr snapshot = m_workbench.analysis().snapshot();
  const auto run = [=](const ExportJobs::Progress&, const std::stop_token& stop) {
    Report report = derivationReport(snapshot, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (QFileInfo(path).suffix().toLower() == QLatin1String("pdf")) {
      const Expected<std::string> pages =
          reportPdf(std::move(report), {lists.schematic, lists.digraph, lists.ttGraph});
      return pages ? writingError(path, *pages) : QString::fromStdString(pages.error().front().message);
    }
    return writingError(path, reportText(report, formOf(path), [&] { return drawingsOf(lists); }));
  };
  m_jobs->add({path, false, run});
}

void WindowExports::chooseAndExportHandout() {
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  const QString plain = tr("Web page (*.html)");
  const QString asking = tr("Web page with exercises (*.html)");
  QString chosen = plain;
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export handout"), name + QStringLiteral("-handout.html"),
                                   plain + QStringLiteral(";;") + asking, &chosen);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".html");
  writeHandout(path, chosen == asking);
}

void WindowExports::exportHandout(const QString& path) {
  writeHandout(path, false);
}

void WindowExports::exportHandoutWithExercises(const QString& path) {
  writeHandout(path, true);
}

void WindowExports::writeHandout(const QString& path, bool asks) {
  const std::optional<ReportLists> lists = shownLists();
  if (!lists) return;
  const SnapshotPtr snapshot = m_workbench.analysis().snapshot();
  const auto mechanism = m_workbench.document().mechanism();
  const std::filesystem::path folder =
      QFile::encodeName(QFileInfo(m_files.source()).absolutePath()).toStdString();
  const auto run = [=, lists = *lists](const ExportJobs::Progress&, const std::stop_token& stop) {
    const MadeHandoutTrain made = handoutTrain(*snapshot, folder, stop);
    std::optional<HandoutExercises> exercises;
    if (asks) {
      exercises = exercisesFor(*mechanism);
      if (!exercises) return tr("Nothing can be asked about this mechanism: export it without exercises.");
    }
    const Expected<std::string> page =
        handoutHtml(snapshot, drawingsOf(lists), made.train, HandoutUse::alone, exercises, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    return page ? writingError(path, *page) : QString::fromStdString(page.error().front().message);
  };
  m_jobs->add({path, false, run});
}

}  // namespace geargraph::inline mainwindow
