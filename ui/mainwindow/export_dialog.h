#pragma once

#include <QDialog>
#include <optional>

#include "ui/mainwindow/export_preview.h"

class QButtonGroup;
class QLabel;
class QListWidget;
class QPushButton;
class QScrollArea;

namespace geargraph {

class ExportOptionsForm;
class ExportPreviewPane;

/// Asks what the export is for, for a format of those that core exports for it (allExporters()), and for its
/// options by their types; shows what would be written, or why nothing can be, before a file is chosen. Not
/// modal.
class ExportDialog final : public QDialog {
  Q_OBJECT

 public:
  /// More links than that, and solids or pictures are made for the preview only when it is asked for.
  static constexpr int kQuickLinks = 60;

  /// `live`: the analysis of the document; null while there is none.
  explicit ExportDialog(SnapshotPtr live, ExportedDocument document = {}, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& live);
  /// @pre exporterWithId(id)
  void choose(std::string_view id);
  [[nodiscard]] const Exporter& exporter() const { return *m_exporter; }
  /// The options that differ from what holds without them, and those that choose the format.
  [[nodiscard]] OptionValues options() const;
  /// The preview of these options; null while it is worked out, or is not.
  [[nodiscard]] ExportPreviewPtr preview() const;

 signals:
  /// `id` of the exporter.
  void wanted(const QString& id, const geargraph::OptionValues& options);

 private:
  QWidget* makePurposes();
  QWidget* makeDetails();
  QWidget* makeButtons();
  void listFormats(ExportPurpose purpose);
  void showFormat();
  void updateReasons();
  void onOptions();
  void requestPreview(bool isAsked = false);
  void showPreview();
  void setWhy(const QString& why);
  void accept() override;

  SnapshotPtr m_live;
  ExportedDocument m_document;
  const Exporter* m_exporter;
  ExportPreviewService* m_previews;
  QButtonGroup* m_purposes;
  QListWidget* m_formats;
  QLabel* m_what;
  QScrollArea* m_scroll;
  ExportOptionsForm* m_options = nullptr;
  QPushButton* m_usual;
  QLabel* m_reason;
  ExportPreviewPane* m_pane;
  QPushButton* m_export = nullptr;
};

}  // namespace geargraph
