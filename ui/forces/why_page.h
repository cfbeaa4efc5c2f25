#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/document/selection.h"
#include "ui/workbench/forces_service.h"

class QComboBox;
class QLabel;
class QLayout;

namespace geargraph {

class DualityLine;
class ExplanationLabel;

/// Why the torques are what they are, of one joint or mesh: the cutset whose torques balance, or which gear
/// drives; and the row of P for speeds with its column for torques. The element is the selected one; a list
/// of joints and meshes selects it, too.
class WhyPage : public QScrollArea {
  Q_OBJECT

 public:
  /// `controls`: the layout that gets the list of elements and the verdict, whose parent is `owner`
  WhyPage(Selection* selection, QLayout& controls, QWidget* owner);

  void show(const ForcesPtr& forces);
  /// Shows or hides the controls.
  void setShown(bool isShown);
  /// While the page is out of sight nothing is explained or highlighted.
  void setAwake(bool awake);
  [[nodiscard]] DualityLine& dualityLine() { return *m_duality; }
  [[nodiscard]] ExplanationLabel& explanation() { return *m_explanation; }

 private:
  void fillElements(const ForcesPtr& forces);
  void followSelection();
  void showVerdict(const ForcesPtr& forces);

  Selection* m_selection;
  QComboBox* m_elements;
  QLabel* m_verdict;
  ExplanationLabel* m_explanation;
  QLabel* m_hint;  ///< in place of an explanation
  DualityLine* m_duality;
  std::vector<ElementId> m_listed;  ///< by the items of the list after its first one
  QStringList m_titles;
};

}  // namespace geargraph
