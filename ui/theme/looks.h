#pragma once

#include <QColor>
#include <QStyle>

#include "core/presentation/drawing/palette.h"

class QLabel;
class QPainter;
class QPalette;
class QRect;
class QStyleOption;
class QWidget;

namespace geargraph {

/// How a widget differs from others of its class, by its property "look".
enum class Look {
  none,
  hint,         ///< a label in the secondary colour
  title,        ///< a label in bold
  heading,      ///< a large label in bold
  problem,      ///< a label in the colour of errors
  empty,        ///< a label that stands for an empty view
  card,         ///< a frame with round corners on the sheet
  banner,       ///< a frame that says something of all below it
  rule,         ///< a line between two parts
  verdict,      ///< a framed label in an ink of its own (setInk)
  note3d,       ///< a warning on the 3D picture
  toast,        ///< a message that goes by itself
  veil,         ///< on the 3D picture, which shines through
  chip,         ///< a button that is a choice of several
  symbol,       ///< the same with a symbol as text
  count,        ///< a button with a number in the status bar
  strongCount,  ///< the one that matters most
  flat,         ///< a button that looks like text
  control,      ///< a button beside fields
  fix,          ///< a button in a row of problems
  cell,         ///< a field in a matrix
  entries,      ///< a matrix, whose type is somewhat larger
  cards,        ///< a list of cards, without a ground of its own
};

[[nodiscard]] Look lookOf(const QWidget* widget);

/// Sets what no painter sees: the font, the palette and the margins of a widget with a look.
void applyLook(QWidget& widget);

/// Sets the colour of a label's text, which follows the theme.
void setInk(QLabel& label, ColorRole role);

/// Applies the looks of a window and all in it again, for another theme or another type scale.
void updateLooks(QWidget& root);

/// The ground of what is chosen: the halo, thinned with the sheet so that type on it stays readable.
[[nodiscard]] QColor chosenColor(Theme theme);
[[nodiscard]] QColor disabledColor(Theme theme);

[[nodiscard]] bool hasState(const QStyleOption& option, QStyle::StateFlag flag);

/// A rectangle with round corners.
struct StyleBox {
  QColor filling;
  QColor edge;
  double radius = 4;
  double edgeWidth = 1;
};
void drawBox(QPainter& painter, const QRect& area, const StyleBox& box);

/// What a frame or a label with a look stands on; nothing for other looks.
void drawFrameOf(Look look, QPainter& painter, const QStyleOption& option);

}  // namespace geargraph
