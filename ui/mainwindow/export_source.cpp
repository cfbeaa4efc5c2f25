#include "ui/mainwindow/export_source.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/presentation/exporters/exporters.h"
#include "ui/models/term_tips.h"

namespace geargraph {

QString spoken(std::string_view text) {
  return text.empty() ? QString() : QString::fromStdString(translated(text));
}

QString ExportedDocument::stem() const {
  return QFileInfo(title).completeBaseName();
}

QString inWindowWords(const std::string& sentence) {
  static const QRegularExpression names(QStringLiteral("--[a-z][a-z-]*"));
  QString text = QString::fromStdString(sentence);
  qsizetype from = 0;
  for (auto match = names.match(text); match.hasMatch(); match = names.match(text, from)) {
    const QString name = match.captured();
    const QString title = QString::fromStdString(exportOptionTitle(name.toStdString()));
    const QString shown =
        title.isEmpty() || title == name ? name : QCoreApplication::translate("exports", "“%1”").arg(title);
    text.replace(match.capturedStart(), match.capturedLength(), shown);
    from = match.capturedStart() + shown.size();
  }
  return text;
}

QString reasonOf(const ExportError& error, const HeardFromExport& heard) {
  if (error.kind == ExportError::Kind::stopped)
    return QCoreApplication::translate("exports", "The export was stopped.");
  if (!error.message.empty()) return inWindowWords(error.message);
  return heard.error.isEmpty() ? QCoreApplication::translate("exports", "The mechanism has errors.")
                               : heard.error;
}

ExportSource exportSourceOf(const MechanismPtr& mechanism, const SnapshotPtr& snapshot,
                            const ExportedDocument& document, const HeardFromExportPtr& heard) {
  ExportSource source;
  source.read = [mechanism]() -> std::variant<Mechanism, ExportError> { return *mechanism; };
  source.snapshot = snapshot && snapshot->isComplete ? snapshot : nullptr;
  source.folder = QFile::encodeName(QFileInfo(document.file).absolutePath()).toStdString();
  source.stem = document.stem().toStdString();
  source.diagnose = [heard](const Diagnostics& found) {
    for (const Diagnostic& each : found) {
      if (each.severity() == Severity::error && heard->error.isEmpty())
        heard->error = QString::fromStdString(each.message);
    }
  };
  source.note = [heard](const ExportNote& note) { heard->notes << inWindowWords(note.text); };
  return source;
}

QString proposedName(const Exporter& exporter, const ExportedDocument& document) {
  if (exporter.files == ExportFiles::folder)
    return document.stem() + QLatin1Char('-') + shownText(exporter.id);
  return document.stem() + QLatin1Char('.') + shownText(exporter.suffix);
}

}  // namespace geargraph
