#pragma once

#include <QColor>
#include <QPalette>

#include "core/presentation/drawing/palette.h"

namespace geargraph::inline theme {

/// A colour of core's palette for a widget.
[[nodiscard]] QColor qColor(Color color);
[[nodiscard]] QColor qColor(ColorRole role, Theme theme);

/// The theme that a widget's palette was made for, so that no view has to be told.
[[nodiscard]] Theme themeOf(const QPalette& palette);

/// The palette of the theme's colours, for all of the application.
[[nodiscard]] QPalette paletteOf(Theme theme);

/// Body type and the smaller one, in pixels of a screen with 96 dots per inch, at the scale applied last.
[[nodiscard]] int bodyPixels();
[[nodiscard]] int smallPixels();
/// A length that goes with the type.
[[nodiscard]] int scaledPixels(int pixels);

/// What a length is multiplied by from now on, until the next call.
void setTypeScale(double scale);

}  // namespace geargraph::inline theme
