#include "ui/mainwindow/edit_commands.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planets.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/workbench.h"

namespace geargraph::inline mainwindow {
namespace {

const QString kMimeType = QStringLiteral("application/x-geargraph+json");

/// A place of a text that is a document in the making is told without its pointer, as the text is not shown.
QString whyUnreadable(const Diagnostics& problems) {
  return EditCommands::tr("The clipboard holds no links: %1").arg(shownText(problems.front().message));
}

}  // namespace

EditCommands::EditCommands(Workbench& workbench, QObject* parent)
    : QObject(parent), m_document(&workbench.document()), m_selection(&workbench.selection()) {}

bool EditCommands::copy() {
  const Mechanism fragment = fragmentOf(*m_document->mechanism(), m_selection->selected());
  if (isEmptyFragment(fragment)) {
    emit refused(tr("Select links to copy; the ground stays where it is."));
    return false;
  }
  const QByteArray json = QByteArray::fromStdString(writeMechanism(fragment));
  auto* content = new QMimeData;
  content->setData(kMimeType, json);
  content->setText(QString::fromUtf8(json));
  QApplication::clipboard()->setMimeData(content);
  emit noted(tr("Copied %1").arg(fragment.n() == 1 ? tr("1 link") : tr("%1 links").arg(fragment.n())));
  return true;
}

void EditCommands::cut() {
  if (!copy()) return;
  std::vector<ElementId> going(m_selection->selected().begin(), m_selection->selected().end());
  std::erase(going, ElementId(m_document->mechanism()->links.front().id));
  m_document->apply(
      {tr("Cut"), [going](const Mechanism& before) { return withoutElements(before, going); }, 0});
}

void EditCommands::paste() {
  const QMimeData* content = QApplication::clipboard()->mimeData();
  if (content == nullptr) return emit refused(tr("The clipboard is empty."));
  const QByteArray json = content->hasFormat(kMimeType) ? content->data(kMimeType) : content->text().toUtf8();
  if (json.trimmed().isEmpty()) return emit refused(tr("The clipboard holds no links."));
  if (static_cast<std::size_t>(json.size()) > kLargestFile) {
    return emit refused(tr("What the clipboard holds is too large to be a mechanism."));
  }
  const Expected<Mechanism> fragment = readMechanism(std::string_view(json.constData(), json.size()));
  if (!fragment) return emit refused(whyUnreadable(fragment.error()));
  insert(*fragment, tr("Paste"));
}

void EditCommands::duplicate() {
  insert(fragmentOf(*m_document->mechanism(), m_selection->selected()), tr("Duplicate"));
}

void EditCommands::insert(const Mechanism& fragment, const QString& text) {
  const MechanismPtr before = m_document->mechanism();
  const bool otherUnit = fragment.unit != before->unit;
  const bool done = m_document->apply(
      {text, [fragment](const Mechanism& into) { return withFragment(into, fragment); }, 0});
  if (!done) return;
  m_selection->select(elementsAdded(*before, *m_document->mechanism()));
  if (otherUnit) {
    emit noted(tr("Pasted as it was drawn in %1: check the lengths, which count in %2 here.")
                   .arg(shownText(fragment.unit), shownText(before->unit)));
  }
}

void EditCommands::makeGround() {
  for (const ElementId& element : m_selection->selected()) {
    if (element.kind != ElementKind::link) continue;
    m_document->apply(
        {tr("Make ground"),
         [link = LinkId(element.id)](const Mechanism& before) { return withGround(before, link); }, 0});
    return;
  }
}

void EditCommands::makePlanets(int total) {
  for (const ElementId& element : m_selection->selected()) {
    if (element.kind != ElementKind::link) continue;
    m_document->apply({tr("Make %1 planets").arg(total),
                       [planet = LinkId(element.id), total](const PlacedMechanism& before) {
                         return withPlanets(before, planet, total);
                       },
                       0});
    return;
  }
}

void EditCommands::insertSet(const Mechanism& set) {
  m_document->apply({tr("Insert %1").arg(QString::fromStdString(set.name).toLower()),
                     [set](const Mechanism& before) -> Expected<Mechanism> {
                       return withInserted(before, set, freePlace(before));
                     },
                     0});
}

}  // namespace geargraph::inline mainwindow
