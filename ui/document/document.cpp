#include "ui/document/document.h"

#include <QUndoCommand>
#include <utility>

#include "core/mechanism/difference.h"
#include "core/mechanism/length_range.h"

namespace geargraph {

/// The only command class of the program: swaps two immutable mechanisms. Undo cannot drift from redo,
/// because neither recomputes anything.
class EditCommand final : public QUndoCommand {
 public:
  EditCommand(Document& document, MechanismPtr after, const Edit& edit)
      : QUndoCommand(edit.text),
        m_document(document),
        m_before(document.mechanism()),
        m_after(std::move(after)),
        m_gesture(edit.gesture) {}

  void redo() override { m_document.publish(m_after); }
  void undo() override { m_document.publish(m_before); }

  /// QUndoStack offers neighbours with equal ids for merging; the gesture's number tells two drags apart.
  [[nodiscard]] int id() const override { return m_gesture == 0 ? -1 : 1; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const EditCommand&>(*next);
    if (other.m_gesture != m_gesture) return false;
    m_after = other.m_after;
    if (*m_before == *m_after) setObsolete(true);  // dragged back to where it was
    return true;
  }

 private:
  Document& m_document;
  MechanismPtr m_before;
  MechanismPtr m_after;
  quint64 m_gesture;
};

Document::Document(QObject* parent)
    : QObject(parent), m_mechanism(std::make_shared<const Mechanism>(emptyMechanism())) {
  connect(&m_undoStack, &QUndoStack::cleanChanged, this,
          [this](bool clean) { emit modifiedChanged(!clean); });
}

bool Document::apply(const Edit& edit) {
  Expected<Mechanism> next = edit.reduce(*m_mechanism);
  if (!next) {
    emit refused(next.error());
    return false;
  }
  if (Diagnostics beyond = rangeDiagnostics(*next); !beyond.empty()) {
    emit refused(beyond);
    return false;
  }
  const bool nothingToDo = edit.gesture == 0 && *next == *m_mechanism;
  if (nothingToDo) return true;
  m_undoStack.push(new EditCommand(*this, std::make_shared<const Mechanism>(std::move(*next)), edit));
  return true;
}

void Document::replace(Mechanism mechanism, const QString& filePath) {
  m_undoStack.clear();
  const bool isElsewhere =
      std::exchange(m_filePath, filePath) != filePath;  // who hears of the one asks for the other
  publish(std::make_shared<const Mechanism>(std::move(mechanism)));
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

void Document::publish(const MechanismPtr& mechanism) {
  if (m_mechanism == mechanism) return;
  const bool moved = isSameButForView(*m_mechanism, *mechanism);
  m_mechanism = mechanism;
  ++m_revision;
  if (!moved) m_mechanicsRevision = m_revision;
  emit changed();
}

}  // namespace geargraph
