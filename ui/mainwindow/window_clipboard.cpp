// Cut, copy, paste and duplicate: what travels is a document in JSON, so that it reaches other windows, other
// programs and text editors.

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_line.h"
#include "ui/models/term_tips.h"

namespace geargraph::inline mainwindow {
namespace {

const QString kMimeType = QStringLiteral("application/x-geargraph+json");

/// A place of a text that is a document in the making is told without its pointer: nobody sees the text.
QString whyUnreadable(const Diagnostics& problems) {
  return MainWindow::tr("The clipboard holds no links: %1").arg(shownText(problems.front().message));
}

}  // namespace

bool MainWindow::copySelected() {
  const Mechanism fragment = fragmentOf(*m_document->mechanism(), m_selection->selected());
  if (isEmptyFragment(fragment)) {
    m_status->showRefusal(tr("Select links to copy; the ground stays where it is."));
    return false;
  }
  const QByteArray json = QByteArray::fromStdString(writeMechanism(fragment));
  auto* content = new QMimeData;
  content->setData(kMimeType, json);
  content->setText(QString::fromUtf8(json));
  QApplication::clipboard()->setMimeData(content);
  m_status->showNote(
      tr("Copied %1").arg(fragment.n() == 1 ? tr("1 link") : tr("%1 links").arg(fragment.n())));
  return true;
}

void MainWindow::cutSelected() {
  if (!copySelected()) return;
  std::vector<ElementId> going(m_selection->selected().begin(), m_selection->selected().end());
  std::erase(going, ElementId(m_document->mechanism()->links.front().id));
  m_document->apply(
      {tr("Cut"), [going](const Mechanism& before) { return withoutElements(before, going); }, 0});
}

void MainWindow::paste() {
  const QMimeData* content = QApplication::clipboard()->mimeData();
  if (content == nullptr) return m_status->showRefusal(tr("The clipboard is empty."));
  const QByteArray json = content->hasFormat(kMimeType) ? content->data(kMimeType) : content->text().toUtf8();
  if (json.trimmed().isEmpty()) return m_status->showRefusal(tr("The clipboard holds no links."));
  if (static_cast<std::size_t>(json.size()) > kLargestFile) {
    return m_status->showRefusal(tr("What the clipboard holds is too large to be a mechanism."));
  }
  const Expected<Mechanism> fragment = readMechanism(std::string_view(json.constData(), json.size()));
  if (!fragment) return m_status->showRefusal(whyUnreadable(fragment.error()));
  insert(*fragment, tr("Paste"));
}

void MainWindow::duplicateSelected() {
  insert(fragmentOf(*m_document->mechanism(), m_selection->selected()), tr("Duplicate"));
}

void MainWindow::insert(const Mechanism& fragment, const QString& text) {
  const MechanismPtr before = m_document->mechanism();
  const bool otherUnit = fragment.unit != before->unit;
  const bool done = m_document->apply(
      {text, [fragment](const Mechanism& into) { return withFragment(into, fragment); }, 0});
  if (!done) return;
  m_selection->select(elementsAdded(*before, *m_document->mechanism()));
  if (otherUnit) {
    m_status->showNote(tr("Pasted as it was drawn in %1: check the lengths, which count in %2 here.")
                           .arg(shownText(fragment.unit), shownText(before->unit)));
  }
}

}  // namespace geargraph::inline mainwindow
