#include "ui/theme/laid_out_at_once.h"

namespace geargraph {

LaidOutAtOnce::LaidOutAtOnce(QWidget* list) : m_list(list), m_wasShown(!list->isHidden()) {
  m_list->hide();
}

LaidOutAtOnce::~LaidOutAtOnce() {
  if (m_wasShown) m_list->show();
}

void removeFrom(QLayout& list, QWidget* control) {
  list.removeWidget(control);
  control->hide();
  control->deleteLater();
}

}  // namespace geargraph
