#include "ui/document/document.h"

#include <QSignalBlocker>
#include <QTimer>
#include <QUndoCommand>
#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/patch.h"

namespace geargraph {

/// The only command class of the program: the difference between two immutable mechanisms. The mechanisms
/// themselves are what the document has kept whole; older ones are made from their neighbour in the history.
class EditCommand final : public QUndoCommand {
 public:
  EditCommand(Document& document, const PlacedMechanism& after, const Edit& edit)
      : QUndoCommand(edit.text),
        m_document(document),
        m_words(edit.text),
        m_language(document.m_language),
        m_before(document.mechanism()),
        m_after(after.pointer()),
        m_unpublished(after),
        m_gesture(edit.gesture) {}
  EditCommand(const EditCommand& other)
      : QUndoCommand(other.text()),
        m_document(other.m_document),
        m_words(other.m_words),
        m_language(other.m_language),
        m_before(other.m_before),
        m_after(other.m_after),
        m_gesture(other.m_gesture),
        m_patch(other.m_patch) {
    m_document.m_historyBytes += bytes();
  }
  ~EditCommand() override { m_document.m_historyBytes -= bytes(); }

  /// Finds the difference, which a step of a gesture can do without that the one before it takes up
  /// (takes()).
  void compare(const Mechanism& before, const Mechanism& after) {
    m_document.m_historyBytes -= bytes();
    m_patch.emplace(before, after);
    m_document.m_historyBytes += bytes();
  }
  [[nodiscard]] bool isEmpty() const { return m_patch->isEmpty(); }
  void speak(const QString& language, int number) {
    setText(language == m_language ? m_words : Document::tr("Step %1").arg(number));
  }
  /// Will a further step of this gesture be merged with this one, which knows what was before it?
  [[nodiscard]] bool takes(const Edit& next) const {
    return next.gesture != 0 && next.gesture == m_gesture && !m_before.expired() &&
           m_before.lock() == m_document.m_gestureStart;
  }

  void redo() override {
    if (m_document.m_rebuilding) return;
    if (m_unpublished) return m_document.publish(*std::exchange(m_unpublished, std::nullopt));
    m_document.step(*m_patch, true, m_after);
  }
  void undo() override {
    if (m_document.m_rebuilding) return;
    m_document.step(*m_patch, false, m_before);
  }

  /// QUndoStack offers neighbours with equal ids for merging; the gesture's number tells two drags apart.
  [[nodiscard]] int id() const override { return m_gesture == 0 ? -1 : 1; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const EditCommand&>(*next);
    if (m_document.m_rebuilding || other.m_gesture != m_gesture) return false;
    const MechanismPtr after = m_document.mechanism();
    MechanismPtr before = m_before.lock();
    if (!before) before = std::make_shared<const Mechanism>(m_patch->back(other.m_patch->back(*after)));
    compare(*before, *after);
    m_before = before;
    m_after = after;
    if (isEmpty()) setObsolete(true);  // dragged back to where it was
    return true;
  }

 private:
  friend class Document;
  [[nodiscard]] std::size_t bytes() const {
    return m_patch ? sizeof(EditCommand) - sizeof(*m_patch) + m_patch->bytes() : 0;
  }

  Document& m_document;
  QString m_words;  ///< of the edit, in its language
  QString m_language;
  std::weak_ptr<const Mechanism> m_before;
  std::weak_ptr<const Mechanism> m_after;
  std::optional<PlacedMechanism> m_unpublished;  ///< until the step is first taken
  quint64 m_gesture;
  std::optional<MechanismPatch> m_patch;  ///< none in a step that the one before it takes up
};

Document::Document(QObject* parent)
    : QObject(parent),
      m_placed(emptyMechanism()),
      m_geometry(std::make_shared<const DerivedGeometry>(m_placed)) {
  connect(&m_undoStack, &QUndoStack::cleanChanged, this,
          [this](bool clean) { emit modifiedChanged(!clean); });
}

void Document::setHistoryLanguage(const QString& code) {
  if (code == m_language) return;
  m_language = code;
  // The stack hands its commands out as constant ones, though they are this document's.
  for (int i = 0; i < m_undoStack.count(); ++i)
    const_cast<EditCommand*>(static_cast<const EditCommand*>(m_undoStack.command(i)))  // NOLINT
        ->speak(code, i + 1);
}

const ElementIndex& Document::elements() const {
  if (!m_elements) m_elements.emplace(mechanism());
  return *m_elements;
}

bool Document::apply(const Edit& edit) {
  if (m_isEmitting) return applyLater(edit);
  const Expected<PlacedMechanism> next = edit.reduce(m_placed);
  if (!next) {
    emit rejected(next.error());
    return false;
  }
  if (const Diagnostics beyond = limitDiagnostics(*next); !beyond.empty()) {
    emit rejected(beyond);
    return false;
  }
  const MechanismPtr before = mechanism();
  const int steps = m_undoStack.index();
  auto command = std::make_unique<EditCommand>(*this, *next, edit);
  const auto* last = steps == 0 ? nullptr : static_cast<const EditCommand*>(m_undoStack.command(steps - 1));
  const bool isTaken = last != nullptr && last->takes(edit) && steps != m_undoStack.cleanIndex();
  if (!isTaken) command->compare(*before, *next);
  const bool nothingToDo = edit.gesture == 0 && command->isEmpty();
  if (nothingToDo) return true;
  m_undoStack.push(command.release());
  if (m_undoStack.index() > steps) m_gestureStart = before;  // merged steps go on with the one they have
  if (m_historyBytes > m_historyLimit) shortenHistory();
  return true;
}

bool Document::applyLater(const Edit& edit) {
  if (m_isReplacing) return false;
  QTimer::singleShot(0, this, [this, edit, of = m_replacements] {
    if (of == m_replacements) apply(edit);
  });
  return true;
}

void Document::goToStep(int steps) {
  GEARGRAPH_REQUIRE(0 <= steps && steps <= m_undoStack.count());
  m_stepsToGo = std::abs(steps - m_undoStack.index());
  m_undoStack.setIndex(steps);
}

/// Goes to the neighbour in the history, whose mechanism is kept or else made from the patch.
void Document::step(const MechanismPatch& patch, bool forward, std::weak_ptr<const Mechanism>& kept) {
  const bool isLast = m_stepsToGo <= 1;
  m_stepsToGo = std::max(0, m_stepsToGo - 1);
  MechanismPtr there = kept.lock();
  if (!there) {
    Mechanism here = m_onTheWay ? *std::exchange(m_onTheWay, std::nullopt) : *mechanism();
    Mechanism made = forward ? patch.forward(std::move(here)) : patch.back(std::move(here));
    if (!isLast) {
      m_onTheWay = std::move(made);
      return;
    }
    there = std::make_shared<const Mechanism>(std::move(made));
    kept = there;
  }
  m_onTheWay.reset();
  if (isLast) {
    publish(there);
  } else {
    m_onTheWay = *there;
  }
}

/// Commands can only be taken from a QUndoStack all together: the newest come back as copies.
void Document::shortenHistory() {
  std::vector<EditCommand*> kept;
  std::size_t bytes = m_historyBytes;
  int dropped = 0;
  for (int i = 0; i < m_undoStack.count(); ++i) {
    const auto& command = static_cast<const EditCommand&>(*m_undoStack.command(i));
    const bool goes = i + 1 < m_undoStack.index() && bytes > m_historyLimit / 4 * 3;
    if (goes) {
      bytes -= command.bytes();
      ++dropped;
    } else {
      kept.push_back(new EditCommand(command));
    }
  }
  if (dropped == 0) {
    for (const EditCommand* command : kept) delete command;
    return;
  }
  const int index = m_undoStack.index() - dropped;
  const int clean = m_undoStack.cleanIndex() - dropped;
  {
    const QSignalBlocker quiet(m_undoStack);
    m_rebuilding = true;
    m_undoStack.clear();
    for (EditCommand* command : kept) m_undoStack.push(command);
    if (clean >= 0) {
      m_undoStack.setIndex(clean);
      m_undoStack.setClean();
    } else {
      m_undoStack.resetClean();
    }
    m_undoStack.setIndex(index);
    m_rebuilding = false;
  }
  emit historyShortened(dropped);
  emit m_undoStack.indexChanged(index);
}

void Document::keepWhole(const MechanismPtr& mechanism) {
  std::erase(m_keptWhole, mechanism);
  m_keptWhole.push_front(mechanism);
  if (m_keptWhole.size() > kKeptWhole) m_keptWhole.pop_back();
}

void Document::replace(Mechanism mechanism, const QString& filePath) {
  m_undoStack.clear();
  m_keptWhole.clear();
  m_gestureStart.reset();
  const bool isElsewhere =
      std::exchange(m_filePath, filePath) != filePath;  // who hears of the one asks for the other
  ++m_replacements;
  m_isReplacing = true;
  publish(std::move(mechanism));
  m_isReplacing = false;
  emit replaced();
  m_undoStack.setClean();
  if (isElsewhere) emit filePathChanged(m_filePath);
}

void Document::markSaved(const QString& filePath) {
  m_undoStack.setClean();
  if (m_filePath == filePath) return;
  m_filePath = filePath;
  emit filePathChanged(m_filePath);
}

void Document::publish(const PlacedMechanism& placed) {
  const MechanismPtr before = mechanism();
  if (before == placed.pointer()) return;
  const bool moved = isSameButForView(*before, placed);
  keepWhole(before);
  keepWhole(placed.pointer());
  m_placed = moved ? m_placed.withSamePlacement(placed.pointer()) : placed;
  if (!moved) m_geometry = std::make_shared<const DerivedGeometry>(placed);
  m_elements.reset();
  ++m_revision;
  if (!moved) m_mechanicsRevision = m_revision;
  m_isEmitting = true;
  emit changed();
  m_isEmitting = false;
}

}  // namespace geargraph

#include "moc_document.cpp"
