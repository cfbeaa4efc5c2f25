#pragma once

#include <QMargins>
#include <QStyle>

#include "ui/theme/looks.h"

class QPainter;
class QStyleOptionButton;
class QStyleOptionToolButton;

namespace geargraph {

/// The buttons that the program paints itself: those of tool bars, and those with a look.
struct ButtonForm {
  QMargins padding;                     ///< with the edge
  int leastWidth = 0, leastHeight = 0;  ///< of what is in it
  double radius = 4;
};

/// The form of a tool button, or nullptr if it looks as in any program.
[[nodiscard]] const ButtonForm* toolButtonForm(const QWidget* button);
[[nodiscard]] const ButtonForm& pushButtonForm(Look look);
[[nodiscard]] QSize roomFor(const ButtonForm& form, QSize content);

/// A tool button with a form: its ground, its icon and text, and the arrow of its menu.
void drawToolButton(const QStyle& style, const QStyleOptionToolButton& option, QPainter& painter,
                    const QWidget& button, const ButtonForm& form);

/// The ground of a push button.
void drawPushButtonGround(const QStyle& style, const QStyleOptionButton& option, QPainter& painter,
                          Look look);

}  // namespace geargraph
