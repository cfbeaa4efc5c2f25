#pragma once

#include <QString>
#include <QWidget>

#include "core/presentation/drawing/palette.h"

namespace geargraph::inline theme {

/// The style sheet of the program in the colours of a theme. Widgets choose a style by the dynamic property
/// "look": "chip" (a rounded button), "symbol" (a narrow one), "control" (a button of a panel), "flat" (one
/// without a frame), "tool" (a tool of the tool bar), "card" (a framed note), "hint" (secondary text),
/// "title", "problem", "number" (a spin box that paints its own arrows).
[[nodiscard]] QString styleSheetOf(Theme theme);

/// Sets the style sheet of a widget only if it differs, because Qt polishes and lays out again whenever one
/// is set.
inline void setSheet(QWidget& widget, const QString& sheet) {
  if (widget.styleSheet() != sheet) widget.setStyleSheet(sheet);
}

}  // namespace geargraph::inline theme
