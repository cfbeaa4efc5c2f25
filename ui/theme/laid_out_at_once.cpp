#include "ui/theme/laid_out_at_once.h"

#include <QLayout>

namespace geargraph::inline theme {

LaidOutAtOnce::LaidOutAtOnce(QWidget* panel) : m_panel(panel) {
  panel->layout()->setEnabled(false);
}

LaidOutAtOnce::~LaidOutAtOnce() {
  if (m_panel->isVisible()) {
    for (QWidget* child : m_panel->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
      const bool isToStayHidden = child->testAttribute(Qt::WA_WState_ExplicitShowHide);
      if (!child->isWindow() && child->isHidden() && !isToStayHidden) child->show();
    }
  }
  m_panel->layout()->setEnabled(true);
  m_panel->layout()->activate();
}

}  // namespace geargraph::inline theme
