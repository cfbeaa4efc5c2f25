#pragma once

#include <QString>

#include "core/theory/analysis/analysis.h"

class QWidget;

namespace geargraph {

/// A view of results: a panel or a drawing that shows what follows from the document. Its window knows it by
/// this contract only, and by its ViewEntry. A view reads immutable values and writes to no other view: an
/// edit goes to the document, what is chosen to the selection, all else is a signal of Views.
class ResultsView {
 public:
  virtual ~ResultsView() = default;

  [[nodiscard]] virtual QWidget& widget() = 0;

  /// Sets the document as it is now, before its analysis: for names and what else needs none.
  virtual void setMechanism(const MechanismPtr& /*mechanism*/) {}
  /// Sets the newest analysis: twice per document, its live part and then all of it.
  virtual void setSnapshot(const SnapshotPtr& /*snapshot*/) {}
  /// Tells whether the view is in sight. One that is not may leave for later what takes long.
  virtual void setAwake(bool /*awake*/) {}
  /// Tells whether what a question of a lesson asks for may be shown. Views whose entry says that they hold
  /// answers are closed as a whole, and need not listen.
  virtual void setAnswersOpen(bool /*isOpen*/) {}

  /// Is everything shown that was asked for? Views::settled() is emitted when it becomes so.
  [[nodiscard]] virtual bool isSettled() const { return true; }
  /// What the view needs and the document does not have, as a sentence shown instead of the results; empty
  /// while there are some.
  [[nodiscard]] virtual QString emptyText() const { return {}; }
};

}  // namespace geargraph
