#include "ui/theme/empty_label.h"

namespace geargraph {

QLabel* emptyLabel(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setProperty("look", "empty");
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  return label;
}

}  // namespace geargraph
