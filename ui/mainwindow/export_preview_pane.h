#pragma once

#include <QWidget>

#include "ui/mainwindow/export_preview.h"

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;

namespace geargraph {

class PictureBox;

/// What an export would write: how much, what is left out, its files, and the beginning of a text or a
/// picture of the one that is chosen.
class ExportPreviewPane : public QWidget {
  Q_OBJECT

 public:
  explicit ExportPreviewPane(QWidget* parent = nullptr);

  void show(const ExportPreview& preview, const Exporter& exporter);
  /// Nothing is worked out before the user asks: it would take long.
  void offer();
  /// It is worked out; until then the last one stays.
  void wait();
  /// Nothing can be written.
  void clear();

 signals:
  void wanted();

 private:
  void showFile(int row);
  void showContent(const PreviewedFile& file, const QString& nothing);

  ExportPreview m_preview;
  QLabel* m_summary;
  QLabel* m_notes;
  QPushButton* m_offer;
  QListWidget* m_files;
  QStackedWidget* m_content;
  QPlainTextEdit* m_text;
  PictureBox* m_picture;
  QLabel* m_nothing;
};

}  // namespace geargraph
