#pragma once

#include "ui/theme/theme_colors.h"

class QApplication;

namespace geargraph {

/// Sets the style, palette and font of the program, with fonts scaled by `typeScale`. May be called again to
/// switch themes: the parts of windows get a PaletteChange event one after the other (IncrementalRestyle).
/// @param isLaidOutNext those of the active window get it at once
void applyTheme(QApplication& application, Theme theme, double typeScale = 1, bool isLaidOutNext = false);

/// The theme chosen in the settings; the system's if none was.
[[nodiscard]] Theme savedTheme();
void saveTheme(Theme theme);
/// Is no theme chosen, so that the program follows the system's?
[[nodiscard]] bool followsSystemTheme();
/// Removes the chosen theme from the settings.
void followSystemTheme();
/// Light or dark, according to the system's palette when it was last asked for.
[[nodiscard]] Theme systemTheme();
/// Asks again, after the system's theme has changed.
void updateSystemTheme();

/// The font scale chosen in the settings; 1 is the normal size.
[[nodiscard]] double savedTypeScale();
void saveTypeScale(double scale);

}  // namespace geargraph
