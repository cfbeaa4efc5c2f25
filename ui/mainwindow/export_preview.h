#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "core/presentation/exporters/exporters.h"
#include "ui/mainwindow/export_source.h"
#include "ui/service/service.h"

namespace geargraph {

/// A file that an export would write.
struct PreviewedFile {
  QString name;  ///< with its folder below the one that is exported
  qint64 bytes = 0;
  QString text;  ///< its beginning, of a file that people read
  QImage image;  ///< of a picture
};

/// What an export would write, found by writing it into a folder that is thrown away.
struct ExportPreview {
  double progress = 0;  ///< 0 to 1, until it is finished
  bool isFinished = false;
  QString why;        ///< why nothing would be written; empty if something would
  QStringList notes;  ///< what the export tells: what it leaves out, how long it took short cuts
  std::vector<PreviewedFile> files;  ///< by name; the main file first
  bool isPart = false;               ///< made with few pictures: names and sizes are not those of the export
  /// Of files that nobody reads: a picture or a text of the same, by ExportFamily::shownBy.
  PreviewedFile shown;

  [[nodiscard]] qint64 bytes() const;
};
using ExportPreviewPtr = std::shared_ptr<const ExportPreview>;

struct ExportPreviewRequest {
  MechanismPtr mechanism;
  SnapshotPtr snapshot;  ///< the newest analysis of it
  ExportedDocument document;
  const Exporter* exporter = nullptr;
  OptionValues options;
};

/// May be called on any thread. Cost: that of the export, and of the one that shows it.
[[nodiscard]] ExportPreview exportPreview(const ExportPreviewRequest& request,
                                          const std::function<void(double)>& progress,
                                          const std::stop_token& stop);

using ExportPreviewService = Service<ExportPreviewRequest, ExportPreviewPtr>;
/// The service of a dialog; the same request twice is worked on once.
[[nodiscard]] ExportPreviewService* makeExportPreviewService(QObject* parent);

}  // namespace geargraph
