#pragma once

#include <QLineEdit>

namespace geargraph {

/// An in-place text editor: Enter or losing the focus accepts the text, Esc cancels. Deletes itself.
class RenameEditor final : public QLineEdit {
  Q_OBJECT

 public:
  RenameEditor(const QString& text, QWidget* parent);

  void finish(bool take);  ///< accepts the text, or cancels

 signals:
  void taken(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  bool m_finished = false;
};

}  // namespace geargraph
