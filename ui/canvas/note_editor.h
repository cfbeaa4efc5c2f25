#pragma once

#include "ui/theme/plain_text_field.h"

namespace geargraph {

/// An in-place editor for the text of a note: Enter or losing the focus accepts the text, Shift+Enter starts
/// a new line, Esc cancels. A text longer than kMaxNoteLength is truncated, and limited() is emitted. Deletes
/// itself.
class NoteEditor final : public PlainTextField {
  Q_OBJECT

 public:
  /// Centred at `middle`, in the parent's coordinates, as far as it stays inside the parent.
  NoteEditor(const QString& text, QPoint middle, QWidget* parent);

  void finish(bool take);  ///< accepts the text, or cancels

 signals:
  /// The text as typed.
  void taken(const QString& text);
  /// Why the text was truncated, as a sentence.
  void limited(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void onTextChanged();
  void fitToText();

  QPoint m_middle;
  bool m_finished = false;
};

}  // namespace geargraph
