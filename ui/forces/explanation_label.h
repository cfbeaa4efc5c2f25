#pragma once

#include <QLabel>
#include <set>

#include "ui/selection/selection.h"
#include "ui/statics/forces_service.h"

namespace geargraph::inline forces {

/// Explains what is selected by the torques: the cutset of one joint with its equation, or which gear of one
/// mesh drives. What the joint cuts off, and what crosses, stays lit in all views while it is explained.
class ExplanationLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ExplanationLabel(Selection* selection, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);
  /// Nothing is explained, and nothing lit, while it cannot be seen.
  void setAwake(bool awake);

 private:
  void explain();
  /// Empty where nothing that can be explained is selected alone; `lit` is what is to stand out with it.
  [[nodiscard]] QString words(std::set<ElementId>& lit) const;

  Selection* m_selection;
  ForcesPtr m_forces;
  bool m_isAwake = false;
};

}  // namespace geargraph::inline forces
