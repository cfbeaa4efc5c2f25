// File > Export derivation and Learn > Show the derivation: both methods worked out, as a web page, PDF,
// LaTeX or Markdown, and in the window.

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>

#include "core/foundations/files/file.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/pages/report_pdf.h"
#include "core/presentation/report/report.h"
#include "ui/canvas/drawing_view.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/picture_jobs.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_files.h"
#include "ui/schematic/schematic_view.h"

namespace geargraph::inline mainwindow {
namespace {

ReportForm formOf(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == QLatin1String("tex")) return ReportForm::latex;
  return suffix == QLatin1String("md") ? ReportForm::markdown : ReportForm::html;
}

/// Why the file could not be written; empty where it was.
QString written(const QString& path, const std::string& bytes) {
  const auto error = writeFile(QFile::encodeName(path).toStdString(), bytes);
  return error ? QString::fromStdString(error->message) : QString();
}

}  // namespace

QString MainWindow::whyNoDerivation() const {
  if (m_document->mechanism()->n() == 0) return tr("There is nothing drawn to derive anything for.");
  if (m_document->mechanism()->n() <= kMostReportLinks) return {};
  return tr("A derivation of more than %1 links is not written: nobody could read it.").arg(kMostReportLinks);
}

void MainWindow::chooseAndExportDerivation() {
  const QString name = QFileInfo(m_files->title()).completeBaseName();
  QString path =
      QFileDialog::getSaveFileName(this, tr("Export derivation"), name + QStringLiteral(".html"),
                                   tr("Web page (*.html);;PDF (*.pdf);;LaTeX (*.tex);;Markdown (*.md)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".html");
  exportDerivation(path);
}

void MainWindow::showDerivation() {
  dock("dock.derivation")->show();
  dock("dock.derivation")->raise();
}

void MainWindow::exportDerivation(const QString& path) {
  const SnapshotPtr snapshot = m_workbench->analysis().snapshot();
  if (!m_workbench->analysis().isComplete()) {
    m_status->showRefusal(tr("The solution is still being worked out. Try again in a moment."));
    return;
  }
  ReportLists lists;  // as the window shows them
  for (DrawingView* each : m_allDrawings) {
    if (each->objectName() == QLatin1String("schematic")) lists.schematic = each->picture();
    if (each->objectName() == QLatin1String("digraph")) lists.digraph = each->picture();
    if (each->objectName() == QLatin1String("ttgraph")) lists.ttGraph = each->picture();
  }
  const QString why = m_schematic->whyNoPicture();
  if (!why.isEmpty()) return m_status->showRefusal(why);
  const auto run = [=](const PictureJobs::Progress&, const std::stop_token& stop) {
    Report report = derivationReport(snapshot, stop);
    if (stop.stop_requested()) return tr("The export was stopped.");
    if (QFileInfo(path).suffix().toLower() == QLatin1String("pdf")) {
      const Expected<std::string> pages =
          reportPdf(std::move(report), {lists.schematic, lists.digraph, lists.ttGraph});
      return pages ? written(path, *pages) : QString::fromStdString(pages.error().front().message);
    }
    const std::string text = reportText(report, formOf(path), [&] {
      const SheetLook look;
      return ReportDrawings{svgOf(lists.schematic, look), svgOf(lists.digraph, look),
                            svgOf(lists.ttGraph, look)};
    });
    return written(path, text);
  };
  m_pictures->add({path, false, run});
}

}  // namespace geargraph::inline mainwindow
