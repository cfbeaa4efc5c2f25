#include "ui/mainwindow/edit_commands.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <memory>
#include <unordered_set>
#include <utility>

#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planets.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/mainwindow/picture_clipboard.h"
#include "ui/models/term_tips.h"
#include "ui/panels/long_edit.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// Above this number of links a picture would not be readable.
constexpr int kMaxPicturedLinks = 2'000;
/// More links than these, or a longer text, are put in on another thread.
constexpr int kMaxAtOnce = 1'000;
constexpr qsizetype kMaxReadAtOnce = 200'000;

/// The marks of the elements in the fragment; those of its ground only if that was selected.
DisplayList partOf(DisplayList drawing, const Mechanism& fragment, bool withGround) {
  std::unordered_set<ElementId> copied;
  for (const Link& link : fragment.links) copied.insert(link.id);
  if (!withGround) copied.erase(fragment.links.front().id);
  for (const Axis& axis : fragment.axes) copied.insert(axis.id);
  for (const TurningJoint& joint : fragment.turningJoints) copied.insert(joint.id);
  for (const GearMesh& mesh : fragment.gearMeshes) copied.insert(mesh.id);
  for (const ShiftElement& coupling : fragment.couplings) copied.insert(coupling.id);
  for (const CanvasNote& note : fragment.view.notes) copied.insert(note.id);
  std::erase_if(drawing.marks, [&](const Mark& mark) { return !copied.contains(mark.element); });
  return drawing;
}

/// "2 links", "1 note", "1 link and 3 notes"
QString countedText(const Mechanism& fragment) {
  const auto tr = [](const char* text) { return EditCommands::tr(text); };
  const auto count = static_cast<int>(fragment.view.notes.size());
  const QString notes = count == 1 ? tr("1 note") : tr("%1 notes").arg(count);
  if (fragment.n() == 0) return notes;
  const QString links = fragment.n() == 1 ? tr("1 link") : tr("%1 links").arg(fragment.n());
  return count == 0 ? links : tr("%1 and %2").arg(links, notes);
}

/// A place of a text that is a document in the making is told without its pointer, as the text is not shown.
QString whyUnreadable(const Diagnostics& problems) {
  return EditCommands::tr("The clipboard holds no links: %1").arg(shownText(problems.front().message));
}

}  // namespace

EditCommands::EditCommands(Workbench& workbench, PictureClipboard* clipboard, PictureOf picture,
                           QWidget* window)
    : QObject(window),
      m_window(window),
      m_document(&workbench.document()),
      m_selection(&workbench.selection()),
      m_clipboard(clipboard),
      m_picture(std::move(picture)) {}

bool EditCommands::copy() {
  const auto fragment =
      std::make_shared<const Mechanism>(fragmentOf(*m_document->mechanism(), m_selection->selected()));
  if (isEmptyFragment(*fragment)) {
    emit rejected(tr("Select links or notes to copy; the ground stays where it is."));
    return false;
  }
  CopiedContent content;
  content.document = fragment;
  content.asText = true;
  if (fragment->n() <= kMaxPicturedLinks) {
    const bool withGround = m_selection->isSelected(fragment->links.front().id);
    content.drawing = [picture = m_picture(), fragment, withGround] {
      return partOf(picture(), *fragment, withGround);
    };
  }
  m_clipboard->copy(std::move(content));
  emit noted(tr("Copied %1").arg(countedText(*fragment)));
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
  if (content == nullptr) return emit rejected(tr("The clipboard is empty."));
  const QByteArray json = content->hasFormat(PictureClipboard::mimeType())
                              ? content->data(PictureClipboard::mimeType())
                              : content->text().toUtf8();
  if (json.trimmed().isEmpty()) return emit rejected(tr("The clipboard holds no links."));
  if (static_cast<std::size_t>(json.size()) > kLargestFile) {
    return emit rejected(tr("What the clipboard holds is too large to be a mechanism."));
  }
  const auto read = [json] { return readMechanism(std::string_view(json.constData(), json.size())); };
  if (json.size() > kMaxReadAtOnce) return insertInBackground(read, tr("Paste"));
  const Expected<Mechanism> fragment = read();
  if (!fragment) return emit rejected(whyUnreadable(fragment.error()));
  insert(*fragment, tr("Paste"));
}

void EditCommands::duplicate() {
  insert(fragmentOf(*m_document->mechanism(), m_selection->selected()), tr("Duplicate"));
}

void EditCommands::insert(const Mechanism& fragment, const QString& text) {
  if (fragment.n() > kMaxAtOnce) return insertInBackground([fragment] { return fragment; }, text);
  const MechanismPtr before = m_document->mechanism();
  const bool done = m_document->apply(
      {text, [fragment](const Mechanism& into) { return withFragment(into, fragment); }, 0});
  if (done) inserted(elementsAdded(*before, *m_document->mechanism()), fragment.unit);
}

void EditCommands::insertInBackground(std::function<Expected<Mechanism>()> read, const QString& text) {
  struct Outcome {
    Diagnostics unreadable;  // why the fragment could not be read
    std::set<ElementId> added;
    std::string unit;
  };
  const auto outcome = std::make_shared<Outcome>();
  const auto work = [read = std::move(read), outcome](
                        const PlacedMechanism& before,
                        const LongEdit::Progress& progress) -> Expected<PlacedMechanism> {
    *outcome = {};
    const Expected<Mechanism> fragment = read();
    if (!fragment) return outcome->unreadable = fragment.error();
    if (progress.stop.stop_requested()) return before;
    Expected<PlacedMechanism> made = unplaced(withFragment(before.mechanism(), *fragment));
    if (made) outcome->added = elementsAdded(before.mechanism(), made->mechanism());
    outcome->unit = fragment->unit;
    return made;
  };
  auto* edit = new LongEdit(m_document, m_window, text, 0, 0, work);
  connect(edit, &LongEdit::ended, this, [this, edit, outcome](const QString& why) {
    if (edit->wasCancelled()) return;
    if (!outcome->unreadable.empty()) return emit rejected(whyUnreadable(outcome->unreadable));
    if (!why.isEmpty()) return emit rejected(why);
    inserted(outcome->added, outcome->unit);
  });
}

/// `unit`: of the fragment they came from.
void EditCommands::inserted(const std::set<ElementId>& added, const std::string& unit) {
  m_selection->select(added);
  const std::string& here = m_document->mechanism()->unit;
  if (unit == here) return;
  emit noted(tr("Pasted as it was drawn in %1: check the lengths, which count in %2 here.")
                 .arg(shownText(unit), shownText(here)));
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

}  // namespace geargraph

#include "moc_edit_commands.cpp"
