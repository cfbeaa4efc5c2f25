#include "ui/mainwindow/export_preview.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QStringDecoder>
#include <QTemporaryDir>
#include <algorithm>
#include <array>

namespace geargraph {
namespace {

/// Of a text, in bytes: more than a pane of a dialog shows.
constexpr qint64 kTextHead = 4096;
/// Of a picture, in pixels: as large as it can be shown.
constexpr int kPictureSide = 1200;
/// Of a folder: of so many files the content is kept.
constexpr std::size_t kReadFiles = 40;

/// Files that people read. Others are text too, but say nothing to them.
constexpr std::array kReadable = {"csv", "dot",  "graphml", "json", "tex", "md",   "mo",
                                  "xml", "urdf", "hpp",     "h",    "py",  "yaml", "txt"};

bool isRead(const QFileInfo& file) {
  const QString suffix = file.suffix().toLower();
  return std::any_of(kReadable.begin(), kReadable.end(),
                     [&](const char* each) { return suffix == QLatin1String(each); });
}

/// The beginning up to its last whole line, if there is one.
QString headOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray bytes = file.read(kTextHead);
  QStringDecoder decode(QStringConverter::Utf8);
  const QString text = decode.decode(bytes);
  if (file.atEnd()) return text;
  const qsizetype end = text.lastIndexOf(QLatin1Char('\n'));
  return (end > 0 ? text.left(end) : text) + QStringLiteral("\n…");
}

QImage imageOf(const QString& path) {
  QImageReader reader(path);
  const QSize size = reader.size();
  if (size.width() > kPictureSide || size.height() > kPictureSide)
    reader.setScaledSize(size.scaled(kPictureSide, kPictureSide, Qt::KeepAspectRatio));
  return reader.read();
}

void readContent(const QString& path, PreviewedFile& file) {
  const QFileInfo info(path);
  if (info.suffix() == QLatin1String("png")) file.image = imageOf(path);
  if (isRead(info)) file.text = headOf(path);
}

std::vector<PreviewedFile> filesBelow(const QString& folder, const QString& main) {
  std::vector<PreviewedFile> files;
  QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (each.hasNext()) {
    const QString path = each.next();
    files.push_back({QDir(folder).relativeFilePath(path), QFileInfo(path).size(), {}, {}});
  }
  std::sort(files.begin(), files.end(), [&](const PreviewedFile& one, const PreviewedFile& other) {
    const bool isMain = one.name == main, isOtherMain = other.name == main;
    return isMain != isOtherMain ? isMain : one.name < other.name;
  });
  for (std::size_t i = 0; i < std::min(files.size(), kReadFiles); ++i)
    readContent(QDir(folder).filePath(files[i].name), files[i]);
  return files;
}

/// Writes into a folder; the reason why it was not written, if so.
struct Written {
  QString why;
  QStringList notes;
};
Written write(const ExportPreviewRequest& request, const Exporter& exporter, const OptionValues& options,
              const QString& path, const std::function<void(double)>& progress, const std::stop_token& stop) {
  const auto heard = std::make_shared<HeardFromExport>();
  ExportContext context(exportSourceOf(request.mechanism, request.snapshot, request.document, heard));
  ExportTarget target{QFile::encodeName(path).toStdString()};
  target.progress = progress;
  const ExportResult result = writeExport(exporter, context, options, target, stop);
  const auto* error = std::get_if<ExportError>(&result);
  return {error == nullptr ? QString() : reasonOf(*error, *heard), heard->notes};
}

bool saysSomething(const PreviewedFile& file) {
  return !file.text.isEmpty() || !file.image.isNull();
}

}  // namespace

qint64 ExportPreview::bytes() const {
  qint64 all = 0;
  for (const PreviewedFile& file : files) all += file.bytes;
  return all;
}

ExportPreview exportPreview(const ExportPreviewRequest& request, const std::function<void(double)>& progress,
                            const std::stop_token& stop) {
  ExportPreview preview;
  preview.isFinished = true;
  const QTemporaryDir folder;
  if (!folder.isValid()) {
    preview.notes << folder.errorString();
    return preview;
  }
  const Exporter& exporter = *request.exporter;
  const ExportFamily& family = familyOf(exporter);
  OptionValues options = request.options;
  for (const auto& [name, value] : family.forPreview)
    options.options[std::string(name)] = {std::string(value)};
  preview.isPart = !family.forPreview.empty();
  const QString name = proposedName(exporter, request.document);
  const Written written = write(request, exporter, options, folder.filePath(name), progress, stop);
  preview.why = written.why;
  preview.notes = written.notes;
  if (stop.stop_requested() || !preview.why.isEmpty()) return preview;
  preview.files = exporter.files == ExportFiles::folder ? filesBelow(folder.filePath(name), {})
                                                        : filesBelow(folder.path(), name);
  const bool isSaid = std::any_of(preview.files.begin(), preview.files.end(), saysSomething);
  const Exporter* shows = family.shownBy.empty() || isSaid ? nullptr : exporterWithId(family.shownBy);
  if (shows == nullptr) return preview;
  const QString path =
      folder.filePath(QStringLiteral("shown.") + QString::fromStdString(std::string(shows->suffix)));
  const OptionValues taken = optionsFor(*shows, request.options);
  if (write(request, *shows, taken, path, {}, stop).why.isEmpty()) readContent(path, preview.shown);
  return preview;
}

ExportPreviewService* makeExportPreviewService(QObject* parent) {
  const auto work = [](const ExportPreviewRequest& request, const ExportPreviewService::Responder& respond) {
    int percent = -1;
    const auto progress = [&](double done) {
      const int now = static_cast<int>(done * 100);
      if (now == std::exchange(percent, now)) return;
      ExportPreview unfinished;
      unfinished.progress = done;
      respond.partly(std::make_shared<const ExportPreview>(std::move(unfinished)));
    };
    respond(std::make_shared<const ExportPreview>(exportPreview(request, progress, respond.stop())));
  };
  const auto same = [](const ExportPreviewRequest& before, const ExportPreviewRequest& now) {
    return before.mechanism == now.mechanism && before.exporter == now.exporter &&
           before.options.options == now.options.options && before.document.file == now.document.file &&
           before.document.title == now.document.title;
  };
  return new ExportPreviewService(work, parent, {.urgency = Urgency::background, .same = same});
}

}  // namespace geargraph
