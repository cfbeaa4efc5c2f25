// File > Export: every format of core's registry, written on the thread of the exports.

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <memory>

#include "core/presentation/exporters/exporters.h"
#include "ui/mainwindow/export_dialog.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/recent_exports.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

void WindowExports::chooseAndExport() {
  auto* dialog = new ExportDialog(m_workbench.analysis().snapshot(), exported(), m_window);
  connect(dialog, &ExportDialog::wanted, this, [this](const QString& id, const OptionValues& options) {
    const Exporter& exporter = *exporterWithId(id.toStdString());
    const QString path = exportPath(exporter);
    if (!path.isEmpty()) exportAs(exporter, options, path);
  });
  m_workbench.analysis().onAnswer(dialog, [dialog](const SnapshotPtr& live) { dialog->setSnapshot(live); });
  dialog->show();
}

ExportedDocument WindowExports::exported() const {
  return {m_files.source(), m_files.title()};
}

/// Where the document was exported last, else beside it.
QString WindowExports::exportFolder() const {
  const QString file = m_files.source();
  const std::vector<RecentExport> before = RecentExports::all(&file);
  if (!before.empty() && QFileInfo(before.front().path).dir().exists())
    return QFileInfo(before.front().path).absolutePath();
  const bool isExample = file.startsWith(QLatin1Char(':'));
  return file.isEmpty() || isExample ? QDir::homePath() : QFileInfo(file).absolutePath();
}

/// Where the user wants it, with the suffix of the format where none was typed.
QString WindowExports::exportPath(const Exporter& exporter) const {
  const QString proposed = QDir(exportFolder()).filePath(proposedName(exporter, exported()));
  if (exporter.files == ExportFiles::folder) {
    return QFileDialog::getSaveFileName(m_window, tr("Export into the new folder"), proposed,
                                        tr("Folders (*)"));
  }
  const QString title = QString::fromStdString(translated(exporter.title));
  const QString suffix = shownText(exporter.suffix);
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export"), proposed,
                                   QStringLiteral("%1 (*.%2);;%3 (*)").arg(title, suffix, tr("All files")));
  if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  return path;
}

void WindowExports::exportAgain(const RecentExport& again) {
  if (const Exporter* exporter = exporterWithId(again.id.toStdString()))
    exportAs(*exporter, again.options, again.path, true);
}

void WindowExports::exportAs(const Exporter& exporter, const OptionValues& options, const QString& path,
                             bool mayOverwrite) {
  const auto heard = std::make_shared<HeardFromExport>();
  const ExportSource source = exportSourceOf(m_workbench.document().mechanism(),
                                             m_workbench.analysis().snapshot(), exported(), heard);
  const auto run = [write = exporter.write, options, path, source, heard, mayOverwrite](
                       const ExportJobs::Progress& progress, const std::stop_token& stop) {
    ExportContext context(source);
    ExportTarget target{QFile::encodeName(path).toStdString(), mayOverwrite};
    target.progress = [&progress](double done) { progress(qRound(done * 100), 100); };
    const ExportResult result = write(context, options, target, stop);
    const auto* error = std::get_if<ExportError>(&result);
    return error == nullptr ? QString() : reasonOf(*error, *heard);
  };
  const bool isLong = exporter.need != ExportNeed::nothing;  // it makes solids or pictures
  m_jobs->add({path, isLong, run, true, [heard] { return heard->notes; }});
  RecentExports::add({m_files.source(), shownText(exporter.id), options, path});
}

}  // namespace geargraph
