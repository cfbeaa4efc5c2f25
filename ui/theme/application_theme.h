#pragma once

#include <QColor>
#include <QPalette>

#include "core/drawing/palette.h"

class QApplication;

namespace geargraph {

/// A colour of core's palette for a widget.
[[nodiscard]] QColor qColor(Color color);
[[nodiscard]] QColor qColor(ColorRole role, Theme theme);

/// The theme that a widget's palette was made for, so that no view has to be told.
[[nodiscard]] Theme themeOf(const QPalette& palette);

/// The palette of the theme's colours, for all of the application.
[[nodiscard]] QPalette paletteOf(Theme theme);

/// Style, palette, style sheet and font of the whole program. May be called again to switch themes: widgets
/// get a PaletteChange event and repaint.
void applyTheme(QApplication& application, Theme theme);

/// Body type, in pixels of a screen with 96 dots per inch.
constexpr int kBodyPixels = 13;
constexpr int kSmallPixels = 12;

}  // namespace geargraph
