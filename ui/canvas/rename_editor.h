#pragma once

#include <QLineEdit>

namespace geargraph::inline canvas {

/// Edits one text where it stands: Enter or leaving it takes the text, Esc leaves it as it was. Deletes
/// itself.
class RenameEditor final : public QLineEdit {
  Q_OBJECT

 public:
  RenameEditor(const QString& text, QWidget* parent);

 signals:
  void taken(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void finish(bool take);
  bool m_finished = false;
};

}  // namespace geargraph::inline canvas
