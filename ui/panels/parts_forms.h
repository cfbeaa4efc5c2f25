#pragma once

#include "ui/panels/property_forms.h"

class QPushButton;

namespace geargraph {

/// The form for one axis: the joints that turn about it, which have its place and direction.
class AxisForm : public PropertyForm {
  Q_OBJECT

 public:
  AxisForm(Document* document, const ElementId& axis);
  void refresh() override;

 private:
  QLabel* m_joints;
};

/// The form for one brake or clutch: its links, and whether it is engaged.
class CouplingForm : public PropertyForm {
  Q_OBJECT

 public:
  CouplingForm(Document* document, const ElementId& coupling);
  void refresh() override;

 private:
  [[nodiscard]] bool isEngagedNow() const;

  QLabel* m_links;
  QPushButton* m_engage;
};

}  // namespace geargraph
