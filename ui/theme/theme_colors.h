#pragma once

#include <QColor>
#include <QPalette>

#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// A colour of core's palette for a widget.
[[nodiscard]] QColor qColor(Color color);
[[nodiscard]] QColor qColor(ColorRole role, Theme theme);

/// The theme that a widget's palette belongs to, so that views need no notification.
[[nodiscard]] Theme themeOf(const QPalette& palette);

/// The palette of the application in the theme's colours.
[[nodiscard]] QPalette paletteOf(Theme theme);

/// The sizes of body text and of small text, in pixels at 96 dpi, at the current type scale.
[[nodiscard]] int bodyPixels();
[[nodiscard]] int smallPixels();
/// A length in pixels multiplied by the type scale.
[[nodiscard]] int scaledPixels(int pixels);

/// Sets the type scale of the functions above.
void setTypeScale(double scale);

}  // namespace geargraph
