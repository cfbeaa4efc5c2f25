#include "ui/theme/plain_text_field.h"

#include <QMouseEvent>

namespace geargraph {

void PlainTextField::mousePressEvent(QMouseEvent* event) {
  // With Shift the selection is extended; Qt drags only without.
  const bool mayDrag = event->button() == Qt::LeftButton && !(event->modifiers() & Qt::ShiftModifier);
  if (mayDrag && textCursor().hasSelection()) {
    QTextCursor cursor = textCursor();
    cursor.clearSelection();
    setTextCursor(cursor);
  }
  QPlainTextEdit::mousePressEvent(event);
}

}  // namespace geargraph

#include "moc_plain_text_field.cpp"
