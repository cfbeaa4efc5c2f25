#pragma once

#include <QDialog>

#include "core/mechanism/model/mechanism.h"
#include "ui/document/document.h"

class QTableWidget;
class QToolButton;

namespace geargraph {

/// The 3D files attached to a link with position, orientation and scale. Every change is an undoable edit.
/// Not modal.
class ShapesDialog final : public QDialog {
  Q_OBJECT

 public:
  ShapesDialog(Document* document, LinkId link, QWidget* parent = nullptr);

  /// Attaches a file. False (and reported by the document) if its path cannot be expressed relative to the
  /// document.
  bool add(const QString& path);

 private:
  void renew();
  void onCell(int row, int column);
  void chooseAndAdd();
  void removeChosen();
  bool apply(const QString& text, const std::vector<LinkShape>& shapes);
  [[nodiscard]] std::vector<LinkShape> shapes() const;

  Document* m_document;
  LinkId m_link;
  QTableWidget* m_table;
  QToolButton* m_remove;
};

}  // namespace geargraph
