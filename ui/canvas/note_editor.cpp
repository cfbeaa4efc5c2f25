#include "ui/canvas/note_editor.h"

#include <QKeyEvent>
#include <algorithm>

#include "core/mechanism/model/notes.h"

namespace geargraph {
namespace {

/// UTF-16 units of the first `count` characters.
qsizetype unitsOf(const QString& text, std::size_t count) {
  qsizetype at = 0;
  for (; at < text.size() && count > 0; ++at) {
    if (text[at].isHighSurrogate() && at + 1 < text.size()) ++at;
    --count;
  }
  return at;
}

}  // namespace

NoteEditor::NoteEditor(const QString& text, QPoint middle, QWidget* parent)
    : PlainTextField(text, parent), m_middle(middle) {
  setObjectName(QStringLiteral("noteEditor"));
  setAccessibleName(tr("Text of the note"));
  setPlaceholderText(tr("Text"));
  setToolTip(tr("Return takes the text, Shift+Return begins a new line, Esc leaves it as it was"));
  setTabChangesFocus(true);
  setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QPlainTextEdit::textChanged, this, &NoteEditor::onTextChanged);
  fitToText();
  selectAll();
}

void NoteEditor::onTextChanged() {
  const QString text = toPlainText();
  const qsizetype most = unitsOf(text, kMaxNoteLength);
  if (most < text.size()) {
    const int cursor = textCursor().position();
    setPlainText(text.left(most));  // comes back here
    QTextCursor at = textCursor();
    at.setPosition(std::min(cursor, static_cast<int>(most)));
    setTextCursor(at);
    emit limited(tr("A note has at most 1,000 characters."));
    return;
  }
  fitToText();
}

void NoteEditor::fitToText() {
  constexpr int kNarrowest = 180, kWidest = 320, kMaxLines = 12, kMargin = 20;
  const QFontMetrics metrics(font());
  int widest = 0;
  int lines = 0;
  const int room = kWidest - kMargin - 8;
  for (const QString& line : toPlainText().split(QLatin1Char('\n'))) {
    const int width = metrics.horizontalAdvance(line);
    widest = std::max(widest, width);
    lines += 1 + width / room;
  }
  const int width = std::clamp(widest + kMargin + 16, kNarrowest, kWidest);
  const int height = std::min(lines, kMaxLines) * metrics.lineSpacing() + kMargin;
  const QRect all = parentWidget()->rect();
  QRect box(m_middle - QPoint(width / 2, height / 2), QSize(width, height));
  box.moveLeft(std::clamp(box.left(), 0, std::max(0, all.right() - width)));
  box.moveTop(std::clamp(box.top(), 0, std::max(0, all.bottom() - height)));
  setGeometry(box);
}

void NoteEditor::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if ((event->modifiers() & Qt::ShiftModifier) != 0) {
        insertPlainText(QStringLiteral("\n"));
      } else {
        finish(true);
      }
      return;
    case Qt::Key_Escape:
      finish(false);
      return;
    default:
      PlainTextField::keyPressEvent(event);
  }
}

void NoteEditor::focusOutEvent(QFocusEvent* event) {
  PlainTextField::focusOutEvent(event);
  // The clipboard's menu takes the focus for a moment only.
  if (event->reason() != Qt::PopupFocusReason) finish(true);
}

void NoteEditor::finish(bool take) {
  if (m_finished) return;  // hiding takes the focus away once more
  m_finished = true;
  if (take) emit taken(toPlainText());
  hide();
  deleteLater();
}

}  // namespace geargraph

#include "moc_note_editor.cpp"
