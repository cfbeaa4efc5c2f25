#pragma once

#include <QLabel>
#include <set>

#include "ui/document/selection.h"
#include "ui/workbench/forces_service.h"

namespace geargraph {

/// Explains the selected element by its torques: the cutset of a joint with its equation, or which gear of a
/// mesh drives. The links that the joint cuts off, and the elements that cross, are highlighted in all views
/// meanwhile.
class ExplanationLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ExplanationLabel(Selection* selection, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);
  /// While it is hidden nothing is explained or highlighted.
  void setAwake(bool awake);

 signals:
  /// Emitted when there is something to explain, or no longer.
  void filled(bool isFilled);

 private:
  void explain();
  /// The explanation; empty unless a single explainable element is selected. `highlighted`: the elements to
  /// highlight.
  [[nodiscard]] QString words(std::set<ElementId>& highlighted) const;

  Selection* m_selection;
  ForcesPtr m_forces;
  bool m_isAwake = false;
};

}  // namespace geargraph
