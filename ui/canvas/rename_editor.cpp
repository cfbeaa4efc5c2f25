#include "ui/canvas/rename_editor.h"

#include <QKeyEvent>

#include "ui/document/typed_length.h"

namespace geargraph {

RenameEditor::RenameEditor(const QString& text, QWidget* parent) : QLineEdit(text, parent) {
  setAlignment(Qt::AlignCenter);
  setMaxLength(kMaxTyped);
  setPlaceholderText(tr("Name"));
  setAccessibleName(tr("Name of the link"));
  selectAll();
}

void RenameEditor::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      finish(true);
      return;
    case Qt::Key_Escape:
      finish(false);
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void RenameEditor::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  // The clipboard's menu takes the focus for a moment only.
  if (event->reason() != Qt::PopupFocusReason) finish(true);
}

void RenameEditor::finish(bool take) {
  if (m_finished) return;  // hiding takes the focus away once more
  m_finished = true;
  if (take) emit taken(text());
  hide();
  deleteLater();
}

}  // namespace geargraph

#include "moc_rename_editor.cpp"
