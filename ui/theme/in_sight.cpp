#include "ui/theme/in_sight.h"

#include <QWidget>

namespace geargraph {

bool isInSight(const QWidget& widget) {
  if (!widget.isVisible()) return false;
  QRect seen = widget.rect();
  for (const QWidget* at = &widget; !at->isWindow(); at = at->parentWidget())
    seen = seen.translated(at->pos()) & at->parentWidget()->rect();
  return !seen.isEmpty();
}

}  // namespace geargraph
