// Saving, and other programs that write the same file. A save that was not carried out is told in the notice
// bar, before all other notices.

#include <QAbstractItemView>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "ui/canvas/note_editor.h"
#include "ui/canvas/rename_editor.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/file_texts.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_files.h"
#include "ui/models/term_tips.h"
#include "ui/panels/number_field.h"

namespace geargraph {
namespace {

const QString kForeignKey = QStringLiteral("file");
const QString kNotSavedKey = QStringLiteral("not saved");

}  // namespace

/// What has just been typed counts, though the field would wait for more of it.
void WindowFiles::finishTyping() const {
  QWidget* typed = m_window->focusWidget();
  if (auto* field = qobject_cast<NumberField*>(typed)) field->commit();
  if (auto* editor = qobject_cast<RenameEditor*>(typed)) editor->finish(true);
  if (auto* editor = qobject_cast<NoteEditor*>(typed)) editor->finish(true);
  if (const QWidget* viewport = typed != nullptr ? typed->parentWidget() : nullptr;
      viewport != nullptr && qobject_cast<QAbstractItemView*>(viewport->parentWidget()) != nullptr)
    typed->clearFocus();  // an editor in a cell or a heading
}

bool WindowFiles::save(const QString& path) {
  finishTyping();
  if (rejectIfOpenElsewhere(path)) return false;
  if (path == m_document->filePath() && m_watch.isForeign()) {
    const Expected<Mechanism> now = readDocument(path);
    if (!now || *now != *m_onDisk) {
      postForeignChange(now, true);
      emit rejected(tr("%1 was not saved: another program has changed it.").arg(title()));
      return false;
    }
    m_watch.accept();
  }
  return saveAnyway(path);
}

bool WindowFiles::saveAnyway(const QString& path) {
  if (rejectIfOpenElsewhere(path)) return false;
  const auto saved = std::make_shared<const Mechanism>(m_saved());
  if (const auto why = writeDocument(*saved, path)) {
    postNotSaved(path, *why);
    return false;
  }
  m_document->markSaved(path);
  took(path);
  m_onDisk = saved;
  emit noted(tr("Saved %1").arg(QFileInfo(path).fileName()));
  return true;
}

void WindowFiles::postNotSaved(const QString& path, const QString& why) {
  emit rejected(why);
  m_notices->post({kNotSavedKey,
                   Severity::error,
                   tr("%1 was not saved. %2").arg(title(), why),
                   {{tr("Try again"), tr("Save it once more"), [this, path] { save(path); }},
                    {tr("Save as…"), tr("Save under another name"), [this] { chooseAndSave(); }},
                    {tr("Later"), tr("The document stays open, with its changes"), {}}},
                   true});
}

void WindowFiles::withdrawSaving() {
  m_notices->withdraw(kForeignKey);
  m_notices->withdraw(kNotSavedKey);
}

bool WindowFiles::saveOrChoose() {
  return m_document->filePath().isEmpty() ? chooseAndSave() : save(m_document->filePath());
}

bool WindowFiles::chooseAndSave() {
  QString proposed = m_document->filePath();
  if (proposed.isEmpty()) proposed = m_proposed;
  if (proposed.isEmpty()) proposed = m_example.isEmpty() ? tr("untitled.geargraph") : title();
  QString path = QFileDialog::getSaveFileName(m_window, tr("Save as"), proposed, documentFilter());
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty() || isTable(path)) {
    path += QStringLiteral(".geargraph");
    if (QFileInfo::exists(path) && !mayReplace(path)) return false;
  }
  return saveAnyway(path);  // the dialog has asked whether to overwrite
}

/// The dialog asks for the name that was typed only.
bool WindowFiles::mayReplace(const QString& path) {
  return QMessageBox::question(m_window, tr("Save as"),
                               tr("%1 exists already. Replace it?").arg(QFileInfo(path).fileName())) ==
         QMessageBox::Yes;
}

bool WindowFiles::mayDiscard() {
  finishTyping();
  if (!m_document->isModified() || isTransient()) return true;
  // Several windows may be closing; the question is about this one.
  if (!m_window->isActiveWindow()) {
    m_window->raise();
    m_window->activateWindow();
  }
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("Save the changes to %1 first?").arg(title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      return saveOrChoose();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

// --- the file on the disk ---------------------------------------------------------------------------------

void WindowFiles::revert() {
  if (m_document->filePath().isEmpty()) return;
  reload();
}

void WindowFiles::reload() {
  const QString path = m_document->filePath();
  std::optional<Expected<Mechanism>> document = readDocument(path, m_window);
  if (!document) return;
  if (!*document) return reportUnreadable(path, document->error());
  emit read();
  m_document->apply(
      takingOver(tr("Revert to the file"), std::make_shared<const Mechanism>(std::move(**document))));
  m_document->markSaved(path);
  took(path);
}

void WindowFiles::onForeignChange() {
  const Expected<Mechanism> now = readDocument(m_document->filePath());
  if (!now || *now != *m_onDisk) return postForeignChange(now, false);
  m_watch.accept();
  m_notices->withdraw(kForeignKey);  // it may have been moved away and back
}

void WindowFiles::postForeignChange(const Expected<Mechanism>& now, bool isSaving) {
  const QString path = m_document->filePath();
  const QString what = now ? textOf(differenceOf(*m_onDisk, *now)) : tr("it can no longer be read");
  const QString text =
      isSaving ? tr("%1 was not saved: another program has changed it (%2). Reloading can be undone.")
                     .arg(title(), what)
      : m_document->isModified()
          ? tr("Another program has changed %1: %2. Your own changes are not saved; reloading can be undone.")
                .arg(title(), what)
          : tr("Another program has changed %1: %2.").arg(title(), what);
  m_notices->post(
      {kForeignKey,
       Severity::warning,
       text,
       {{tr("Reload"), tr("Load the contents of the file"), [this] { reload(); }},
        {tr("Overwrite"), tr("Save this window's document over it"), [this, path] { saveAnyway(path); }},
        {tr("Keep both"), tr("Save this window's document under another name"), [this] { chooseAndSave(); }},
        {tr("Later"), tr("Saving will ask again"), {}}},
       isSaving});
}

void WindowFiles::onRemoved() {
  const QString path = m_document->filePath();
  m_document->markUnsaved();  // else the window would close, and the document be gone
  m_notices->post({kForeignKey,
                   Severity::warning,
                   tr("Another program has moved or deleted %1.").arg(title()),
                   {{tr("Save again"), tr("Write it where it was"), [this, path] { saveAnyway(path); }},
                    {tr("Save as…"), tr("Save under another name"), [this] { chooseAndSave(); }},
                    {tr("Later"), tr("The document stays open"), {}}}});
}

}  // namespace geargraph
