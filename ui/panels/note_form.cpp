#include "ui/panels/note_form.h"

#include <QEvent>
#include <QSignalBlocker>

#include "core/mechanism/model/notes.h"
#include "ui/models/term_tips.h"
#include "ui/theme/plain_text_field.h"

namespace geargraph {

NoteForm::NoteForm(Document* document, std::vector<ElementId> notes)
    : PropertyForm(document, std::move(notes)) {
  if (elements().size() != 1) {
    setTitle(tr("%1 notes").arg(elements().size()));
    addNote(tr("Select one note to change its text."));
    return;
  }
  setTitle(tr("Note"));
  constexpr int kLines = 6;
  m_text = new PlainTextField(this);
  m_text->setObjectName(QStringLiteral("noteText"));
  m_text->setAccessibleName(tr("Text of the note"));
  m_text->setToolTip(tr("The text on the sheet of the digraph"));
  m_text->setTabChangesFocus(true);
  m_text->setFixedHeight(kLines * m_text->fontMetrics().lineSpacing() + 12);
  m_text->installEventFilter(this);
  addWide(m_text);
  connect(m_text, &QPlainTextEdit::textChanged, this, &NoteForm::take);
}

bool NoteForm::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_text && event->type() == QEvent::FocusIn) newGesture();
  if (watched == m_text && event->type() == QEvent::FocusOut && isAboutExisting()) {
    showWrong({});  // a text that was rejected gives way to the one that there is
    refresh();
  }
  return PropertyForm::eventFilter(watched, event);
}

void NoteForm::take() {
  const std::string text = noteText(m_text->toPlainText().toStdString());
  const CanvasNote* const note = mechanism().find(NoteId(elements().front().id));
  if (note == nullptr || note->text == text) return;
  m_isTaking = true;
  apply(tr("Change note"), [text](const Mechanism& before, const ElementId& element) {
    return withNoteText(before, NoteId(element.id), text);
  });
  m_isTaking = false;
}

void NoteForm::refresh() {
  // Another text in the middle of an undo of the field would leave Qt with a place that is not there.
  if (m_text == nullptr || m_isTaking) return;
  const CanvasNote* const note = mechanism().find(NoteId(elements().front().id));
  const QString now = shownText(note->text);
  // What is being typed stays as it is, with its blanks and its cursor.
  const bool isTyped = m_text->hasFocus() && noteText(m_text->toPlainText().toStdString()) == note->text;
  if (isTyped || m_text->toPlainText() == now) return;
  const QSignalBlocker quiet(m_text);
  m_text->setPlainText(now);
}

}  // namespace geargraph

#include "moc_note_form.cpp"
