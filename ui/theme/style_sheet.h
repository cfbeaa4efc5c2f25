#pragma once

#include <QString>
#include <QWidget>

#include "core/presentation/drawing/palette.h"

namespace geargraph::inline theme {

/// The style sheet of the program in the colours of a theme. Widgets ask for a look by the dynamic property
/// "look": "chip" (a rounded button), "symbol" (a narrow one), "control" (a button of a panel), "flat" (one
/// without a frame), "tool" (a tool of the tool bar), "card" (a framed note), "hint" (secondary text),
/// "title", "problem", "number" (a spin box that paints its arrows itself).
[[nodiscard]] QString styleSheetOf(Theme theme);

/// The widget's own sheet, where it is another: Qt polishes and lays out anew at every sheet that is set.
inline void setSheet(QWidget& widget, const QString& sheet) {
  if (widget.styleSheet() != sheet) widget.setStyleSheet(sheet);
}

}  // namespace geargraph::inline theme
