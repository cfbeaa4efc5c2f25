#include "ui/mainwindow/window_exports.h"

#include <QFileDialog>
#include <QFileInfo>
#include <functional>

#include "core/foundations/files/file.h"
#include "core/foundations/files/stoppable_sink.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "ui/mainwindow/csv_dialog.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/export_source.h"
#include "ui/models/term_tips.h"
#include "ui/reading/print_dialog.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

QString withSuffix(QString path, const QString& suffix) {
  if (QFileInfo(path).suffix().isEmpty()) path += suffix;
  return path;
}

/// More of them take longer than a glance, so that a notice tells of them.
constexpr qint64 kManyEntries = 1'000'000;

/// @param write writes until the sink fails
ExportJobs::Job tableJob(const QString& path, qint64 entries, const std::function<void(ByteSink&)>& write) {
  const auto run = [path, write](const ExportJobs::Progress&, const std::stop_token& stop) {
    AtomicFile file(QFile::encodeName(path).toStdString());
    StoppableSink sink(file, stop);
    write(sink);
    if (stop.stop_requested()) return WindowExports::tr("The export was stopped.");
    const auto error = file.commit();
    return error ? QString::fromStdString(error->message) : QString();
  };
  return {path, entries > kManyEntries, run};
}

}  // namespace

WindowExports::WindowExports(Workbench& workbench, const WindowFiles& files, Sources views, ExportJobs* jobs,
                             PictureClipboard* clipboard, QWidget* window)
    : QObject(window),
      m_workbench(workbench),
      m_files(files),
      m_views(std::move(views)),
      m_jobs(jobs),
      m_clipboard(clipboard),
      m_window(window) {
  connect(m_jobs, &ExportJobs::finished, this, &WindowExports::onWritten);
  connect(m_jobs, &ExportJobs::failed, this, &WindowExports::rejected);
  connect(m_jobs, &ExportJobs::told, this, &WindowExports::noted);
}

void WindowExports::exportCsv(const ResultTablePtr& table, const QString& path, const CsvOptions& options) {
  m_jobs->add(tableJob(path, qint64{table->rows()} * table->columns(), [table, options](ByteSink& sink) {
    writeResultCsv(sink, *table, options, CsvEntries::asShown);
  }));
}

/// Asks for the options, then for the file.
void WindowExports::chooseAndExportResult(const ResultTablePtr& table) {
  const QString name = shownText(table->result().asciiName);
  auto* dialog = new CsvDialog(name, m_window);
  connect(dialog, &QDialog::accepted, this, [this, dialog, name, table] {
    const CsvOptions options = dialog->options();
    const QString path = QFileDialog::getSaveFileName(
        m_window, tr("Export matrix"), name + QStringLiteral(".csv"), tr("CSV files (*.csv);;All files (*)"));
    if (!path.isEmpty()) exportCsv(table, withSuffix(path, QStringLiteral(".csv")), options);
  });
  dialog->show();
}

void WindowExports::chooseAndExportTable(const QString& name, const QString& csv) {
  const QString path = QFileDialog::getSaveFileName(m_window, tr("Export table"), name,
                                                    tr("CSV files (*.csv);;All files (*)"));
  if (path.isEmpty()) return;
  const auto write = [text = csv.toStdString()](ByteSink& sink) { sink.write(text); };
  m_jobs->add(tableJob(withSuffix(path, QStringLiteral(".csv")), 0, write));
}

void WindowExports::print(const PrintedPagesPtr& pages, const std::shared_ptr<QPrinter>& printer) {
  const auto run = [pages, printer](const ExportJobs::Progress&, const std::stop_token& stop) {
    return PrintDialog::print(*pages, *printer, stop);
  };
  m_jobs->add({printer->outputFileName(), false, run});
}

void WindowExports::chooseAndSaveTrace() {
  if (m_views.view3d->traces().empty()) return;
  const QString path = QFileDialog::getSaveFileName(m_window, tr("Save the traced path"), tr("path.csv"),
                                                    tr("CSV files (*.csv);;All files (*)"));
  if (!path.isEmpty()) saveTrace(path);
}

bool WindowExports::saveTrace(const QString& path) {
  const std::string csv = pathCsv(m_views.view3d->traces().back().path, m_views.view3d->stage()->unit);
  if (const auto error = writeFile(path.toStdString(), csv)) {
    emit rejected(QString::fromStdString(error->message));
    return false;
  }
  emit noted(tr("Saved %1").arg(QFileInfo(path).fileName()));
  return true;
}

void WindowExports::chooseAndSaveSpeeds() {
  const QString path = QFileDialog::getSaveFileName(m_window, tr("Save the speeds"), tr("speeds.csv"),
                                                    tr("CSV files (*.csv);;All files (*)"));
  if (!path.isEmpty()) saveSpeeds(path);
}

bool WindowExports::saveSpeeds(const QString& path) {
  const QFileInfo file(path);
  int number = 0;
  for (const CurveSheet& sheet : m_views.motion->sheets()) {
    const QString next =
        ++number == 1
            ? path
            : file.path() +
                  QStringLiteral("/%1-%2.%3").arg(file.completeBaseName()).arg(number).arg(file.suffix());
    if (const auto error = writeFile(QFile::encodeName(next).toStdString(), curvesCsv(sheet))) {
      emit rejected(QString::fromStdString(error->message));
      return false;
    }
  }
  emit noted(tr("Saved %1").arg(file.fileName()));
  return number > 0;
}

}  // namespace geargraph

#include "moc_window_exports.cpp"
