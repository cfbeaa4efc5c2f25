#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <concepts>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/element_index.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline bodies {
class DerivedGeometry;
}  // namespace geargraph::inline bodies

namespace geargraph::inline model {
class MechanismPatch;
}  // namespace geargraph::inline model

namespace geargraph::inline document {

/// A pure function from one mechanism to the next; one that reads the placement takes and gives placed ones,
/// so that the document's is not computed again, and the next one's comes along.
class Reduce {
 public:
  template <class Function>
  requires std::invocable<const Function&, const PlacedMechanism&> Reduce(
      Function function)  // NOLINT(google-explicit-constructor): as a std::function
      : m_function([function = std::move(function)](const PlacedMechanism& before) {
          return unplaced(function(before));
        }) {}

  Expected<PlacedMechanism> operator()(const PlacedMechanism& before) const { return m_function(before); }

 private:
  std::function<Expected<PlacedMechanism>(const PlacedMechanism&)> m_function;
};

/// One change of the document: its name in the undo list, and what changes.
struct Edit {
  QString text;
  Reduce reduce;
  /// Edits of one gesture (a drag, a spin) are one undo step: give them the number of Document::newGesture().
  /// 0: a step of its own.
  quint64 gesture = 0;
};

/// The document of one window: the mechanism now, its history, and the file it belongs to. The only way to
/// change it is apply(); what every view sees is an immutable value with a revision that only grows.
///
/// The history holds the differences between documents (core/mechanism/model/patch.h), beside the documents
/// of the last kKeptWhole steps. Beyond the limit of its memory the oldest steps go, a quarter at a time.
class Document : public QObject {
  Q_OBJECT

 public:
  /// Memory of the differences, in bytes: some hundred for most edits, so that 100,000 steps fit in.
  static constexpr std::size_t kHistoryLimit = std::size_t{256} << 20;
  /// Documents that are kept whole, so that undoing the last steps computes nothing.
  static constexpr std::size_t kKeptWhole = 16;

  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const MechanismPtr& mechanism() const { return m_placed.pointer(); }
  /// The mechanism as it is now with its placement, which edits, forms and the analysis share.
  [[nodiscard]] const PlacedMechanism& placed() const { return m_placed; }
  /// All geometry that follows from it, computed on demand by the thread that asks first. While only places
  /// in the drawings change it stays the same object, with the mechanism of the first of these versions.
  [[nodiscard]] const std::shared_ptr<const DerivedGeometry>& geometry() const { return m_geometry; }
  /// The elements of the mechanism as it is now, by id: made when first asked for after an edit.
  [[nodiscard]] const ElementIndex& elements() const;
  [[nodiscard]] quint64 revision() const { return m_revision; }
  /// The revision that last changed more than where things stand in the drawings: what was computed for it
  /// holds for the mechanism now.
  [[nodiscard]] quint64 mechanicsRevision() const { return m_mechanicsRevision; }
  [[nodiscard]] QUndoStack& undoStack() { return m_undoStack; }

  /// The memory that the differences in the history hold, at most the limit and the newest step.
  [[nodiscard]] std::size_t historyBytes() const { return m_historyBytes; }
  void setHistoryLimit(std::size_t bytes) { m_historyLimit = bytes; }

  /// Applies an edit, or reports in refused() and in the result why not; a refused edit changes nothing. An
  /// edit that gives back an equal mechanism makes no undo step. Refused is, too, what could be saved and not
  /// opened again (core/mechanism/model/limits.h).
  bool apply(const Edit& edit);
  /// Undoes or repeats steps until this many of undoStack() are done; views hear of the last one only.
  /// Cost: that of a patch for each step in between. @pre 0 <= steps <= undoStack().count()
  void goToStep(int steps);
  /// A number for the edits of one gesture, never given before.
  [[nodiscard]] quint64 newGesture() { return ++m_lastGesture; }

  /// Takes the place of the document: New and Open. The history is cleared.
  void replace(Mechanism mechanism, const QString& filePath);

  [[nodiscard]] const QString& filePath() const { return m_filePath; }
  /// The mechanism as it is now is what stands in the file.
  void markSaved(const QString& filePath);
  /// The file does not hold the document any more, so it is modified until it is saved, whatever is undone.
  void markUnsaved() { m_undoStack.resetClean(); }
  [[nodiscard]] bool isModified() const { return !m_undoStack.isClean(); }

 signals:
  void changed();                        ///< another mechanism: read mechanism() and revision()
  void replaced();                       ///< after changed(): it is another document, by New or Open
  void refused(const Diagnostics& why);  ///< an edit was refused; nothing changed
  void modifiedChanged(bool modified);
  void filePathChanged(const QString& filePath);
  void historyShortened(int steps);  ///< the number of oldest steps that were dropped

 private:
  friend class EditCommand;
  void publish(const PlacedMechanism& placed);
  void step(const MechanismPatch& patch, bool forward, std::weak_ptr<const Mechanism>& kept);
  void keepWhole(const MechanismPtr& mechanism);
  void shortenHistory();

  PlacedMechanism m_placed;
  std::shared_ptr<const DerivedGeometry> m_geometry;
  mutable std::optional<ElementIndex> m_elements;  ///< of the mechanism now; empty: not asked for yet
  std::deque<MechanismPtr> m_keptWhole;            ///< the newest first
  MechanismPtr m_gestureStart;                     ///< what the newest step began with
  std::size_t m_historyBytes = 0;
  std::size_t m_historyLimit = kHistoryLimit;
  bool m_rebuilding = false;            ///< the history; nothing is published then
  int m_stepsToGo = 0;                  ///< of goToStep(); only the last is published
  std::optional<Mechanism> m_onTheWay;  ///< the document between two of these steps
  quint64 m_revision = 0;
  quint64 m_mechanicsRevision = 0;
  quint64 m_lastGesture = 0;
  QUndoStack m_undoStack;
  QString m_filePath;
};

}  // namespace geargraph::inline document
