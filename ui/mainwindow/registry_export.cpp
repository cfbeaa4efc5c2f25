// File > Export: every format of core's registry, written on the thread of the exports.

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <memory>

#include "core/presentation/exporters/exporters.h"
#include "ui/mainwindow/export_dialog.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// What an export says while it runs: notes for the user, and the first error of the mechanism.
struct Heard {
  QStringList notes;
  QString error;
};

/// Why nothing was written, as a sentence.
QString reasonOf(const ExportError& error, const Heard& heard) {
  if (error.kind == ExportError::Kind::stopped) return WindowExports::tr("The export was stopped.");
  if (!error.message.empty()) return QString::fromStdString(error.message);
  return heard.error.isEmpty() ? WindowExports::tr("The mechanism has errors.") : heard.error;
}

ExportSource sourceFor(const MechanismPtr& mechanism, const SnapshotPtr& snapshot, const QString& document,
                       const QString& title, const std::shared_ptr<Heard>& heard) {
  ExportSource source;
  source.read = [mechanism]() -> std::variant<Mechanism, ExportError> { return *mechanism; };
  source.snapshot = snapshot;
  source.folder = QFile::encodeName(QFileInfo(document).absolutePath()).toStdString();
  source.stem = QFileInfo(title).completeBaseName().toStdString();
  source.diagnose = [heard](const Diagnostics& found) {
    for (const Diagnostic& each : found) {
      if (each.severity() == Severity::error && heard->error.isEmpty())
        heard->error = QString::fromStdString(each.message);
    }
  };
  source.note = [heard](const ExportNote& note) { heard->notes << QString::fromStdString(note.text); };
  return source;
}

}  // namespace

void WindowExports::chooseAndExport() {
  auto* dialog = new ExportDialog(m_workbench.analysis().snapshot(), m_window);
  connect(dialog, &ExportDialog::wanted, this, [this](const QString& id, const OptionValues& options) {
    const Exporter& exporter = *exporterWithId(id.toStdString());
    const QString path = exportPath(exporter);
    if (!path.isEmpty()) exportAs(exporter, options, path);
  });
  m_workbench.analysis().onAnswer(dialog, [dialog](const SnapshotPtr& live) { dialog->setSnapshot(live); });
  dialog->show();
}

/// Where the user wants it, with the suffix of the format where none was typed.
QString WindowExports::exportPath(const Exporter& exporter) const {
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  const QString title = QString::fromStdString(translated(exporter.title));
  if (exporter.files == ExportFiles::folder) {
    return QFileDialog::getSaveFileName(
        m_window, tr("Export into the new folder"),
        QStringLiteral("%1-%2").arg(
            name, QString::fromUtf8(exporter.id.data(), static_cast<qsizetype>(exporter.id.size()))),
        tr("Folders (*)"));
  }
  const QString suffix =
      QString::fromUtf8(exporter.suffix.data(), static_cast<qsizetype>(exporter.suffix.size()));
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export"), name + QLatin1Char('.') + suffix,
                                   QStringLiteral("%1 (*.%2);;%3 (*)").arg(title, suffix, tr("All files")));
  if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  return path;
}

void WindowExports::exportAs(const Exporter& exporter, const OptionValues& options, const QString& path) {
  const auto heard = std::make_shared<Heard>();
  const SnapshotPtr& there = m_workbench.analysis().snapshot();
  const ExportSource source =
      sourceFor(m_workbench.document().mechanism(), there && there->isComplete ? there : nullptr,
                m_files.source(), m_files.title(), heard);
  const auto run = [write = exporter.write, options, path, source, heard](
                       const ExportJobs::Progress& progress, const std::stop_token& stop) {
    ExportContext context(source);
    ExportTarget target{QFile::encodeName(path).toStdString()};
    target.progress = [&progress](double done) { progress(qRound(done * 100), 100); };
    const ExportResult result = write(context, options, target, stop);
    const auto* error = std::get_if<ExportError>(&result);
    return error == nullptr ? QString() : reasonOf(*error, *heard);
  };
  const bool isLong = exporter.need != ExportNeed::nothing;  // it makes solids or pictures
  m_jobs->add({path, isLong, run, true, [heard] { return heard->notes; }});
}

}  // namespace geargraph
