#include "ui/theme/control_button.h"

namespace geargraph {

QToolButton* controlButton(const QString& name, const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setText(text);
  button->setToolTip(tip);
  button->setProperty("look", "control");
  return button;
}

}  // namespace geargraph
