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

namespace geargraph {
class DerivedGeometry;
}  // namespace geargraph

namespace geargraph {
class MechanismPatch;
}  // namespace geargraph

namespace geargraph {

/// A pure function from one mechanism to the next; functions on PlacedMechanism reuse the document's
/// placement and pass on that of the result.
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

/// A change of the document: its name in the undo list, and its function.
struct Edit {
  QString text;
  Reduce reduce;
  /// Edits of one gesture (a drag, spinning a value) form one undo step: use the same number from
  /// Document::newGesture(). 0: a step of its own.
  quint64 gesture = 0;
};

/// The document of a window: the current mechanism, its history, and its file. apply() is the only way to
/// change it; views see an immutable value with an increasing revision.
///
/// The history stores the differences between documents (core/mechanism/model/patch.h), and the whole
/// documents of the last kKeptWhole steps. Above its memory limit the oldest quarter of the steps is dropped.
class Document : public QObject {
  Q_OBJECT

 public:
  /// The memory limit of the differences, in bytes: some hundred for most edits, so that 100,000 steps fit.
  static constexpr std::size_t kHistoryLimit = std::size_t{256} << 20;
  /// The number of documents kept whole, so that undoing the last steps costs nothing.
  static constexpr std::size_t kKeptWhole = 16;

  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const MechanismPtr& mechanism() const { return m_placed.pointer(); }
  /// The current mechanism with its placement, shared by edits, forms and the analysis.
  [[nodiscard]] const PlacedMechanism& placed() const { return m_placed; }
  /// The geometry derived from it, computed on demand by the first thread that needs it. The object stays the
  /// same while only places in the drawings change; its mechanism is then that of the first of these
  /// versions.
  [[nodiscard]] const std::shared_ptr<const DerivedGeometry>& geometry() const { return m_geometry; }
  /// The elements of the current mechanism by id; built on first use after an edit.
  [[nodiscard]] const ElementIndex& elements() const;
  [[nodiscard]] quint64 revision() const { return m_revision; }
  /// The last revision that changed more than places in the drawings: results for it are valid for the
  /// current mechanism.
  [[nodiscard]] quint64 mechanicsRevision() const { return m_mechanicsRevision; }
  [[nodiscard]] QUndoStack& undoStack() { return m_undoStack; }

  /// The memory used by the differences in the history, at most the limit plus the newest step.
  [[nodiscard]] std::size_t historyBytes() const { return m_historyBytes; }
  void setHistoryLimit(std::size_t bytes) { m_historyLimit = bytes; }

  /// Applies an edit. A rejected edit changes nothing: the result is false, and rejected() has the reason. An
  /// edit without a change makes no undo step. Documents that could be saved but not opened again are
  /// rejected too (core/mechanism/model/limits.h).
  ///
  /// While changed() is emitted, controls that are taken away may commit what was typed: such an edit is
  /// applied when control returns to the event loop, and the result is true; that of a document that is being
  /// replaced is discarded.
  bool apply(const Edit& edit);
  /// Undoes or redoes steps until this many of undoStack() are done; changed() is emitted for the last one
  /// only.
  /// Cost: that of a patch for each step in between. @pre 0 <= steps <= undoStack().count()
  void goToStep(int steps);
  /// A new number for the edits of one gesture.
  [[nodiscard]] quint64 newGesture() { return ++m_lastGesture; }

  /// Replaces the document, for New and Open, and clears the history.
  void replace(Mechanism mechanism, const QString& filePath);

  /// The language that texts of edits have from now on, by its letters. Steps that were named in another one
  /// are called by their number until it comes back.
  void setHistoryLanguage(const QString& code);

  [[nodiscard]] const QString& filePath() const { return m_filePath; }
  /// Records that the current mechanism has been saved to the file.
  void markSaved(const QString& filePath);
  /// Records that the file no longer has the document, so that it counts as modified until saved, whatever is
  /// undone.
  void markUnsaved() { m_undoStack.resetClean(); }
  [[nodiscard]] bool isModified() const { return !m_undoStack.isClean(); }

 signals:
  void changed();                         ///< another mechanism: read mechanism() and revision()
  void replaced();                        ///< after changed(): the document was replaced by New or Open
  void rejected(const Diagnostics& why);  ///< an edit was rejected; nothing changed
  void modifiedChanged(bool modified);
  void filePathChanged(const QString& filePath);
  void historyShortened(int steps);  ///< the number of oldest steps that were dropped

 private:
  friend class EditCommand;
  bool applyLater(const Edit& edit);
  void publish(const PlacedMechanism& placed);
  void step(const MechanismPatch& patch, bool forward, std::weak_ptr<const Mechanism>& kept);
  void keepWhole(const MechanismPtr& mechanism);
  void shortenHistory();

  PlacedMechanism m_placed;
  std::shared_ptr<const DerivedGeometry> m_geometry;
  mutable std::optional<ElementIndex> m_elements;  ///< of the current mechanism; empty: not built yet
  std::deque<MechanismPtr> m_keptWhole;            ///< the newest first
  MechanismPtr m_gestureStart;                     ///< the mechanism before the newest step
  std::size_t m_historyBytes = 0;
  std::size_t m_historyLimit = kHistoryLimit;
  bool m_isEmitting = false;   ///< changed() is being emitted
  bool m_isReplacing = false;  ///< for replace()
  quint64 m_replacements = 0;
  bool m_rebuilding = false;            ///< the history is being rebuilt; nothing is published then
  int m_stepsToGo = 0;                  ///< of goToStep(); only the last is published
  std::optional<Mechanism> m_onTheWay;  ///< the document between two of these steps
  quint64 m_revision = 0;
  quint64 m_mechanicsRevision = 0;
  quint64 m_lastGesture = 0;
  QString m_language;  ///< of the texts of edits
  QUndoStack m_undoStack;
  QString m_filePath;
};

}  // namespace geargraph
