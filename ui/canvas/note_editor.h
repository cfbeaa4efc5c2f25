#pragma once

#include <QPlainTextEdit>

namespace geargraph::inline canvas {

/// Edits the text of a note where it is: Return or leaving it takes the text, Shift+Return begins a new line,
/// Esc leaves it as it was. Longer texts than a note may have are cut, and limited() tells. Deletes itself.
class NoteEditor final : public QPlainTextEdit {
  Q_OBJECT

 public:
  /// Around this place of the parent, which it stays inside of.
  NoteEditor(const QString& text, QPoint middle, QWidget* parent);

 signals:
  /// As it was typed.
  void taken(const QString& text);
  /// Why the text does not grow any more, as a sentence.
  void limited(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void finish(bool take);
  void onTextChanged();
  void fitToText();

  QPoint m_middle;
  bool m_finished = false;
};

}  // namespace geargraph::inline canvas
