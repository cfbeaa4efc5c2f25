#pragma once

#include "ui/theme/theme_colors.h"

class QApplication;

namespace geargraph::inline theme {

/// Style, palette, style sheet and font of the whole program, type `typeScale` times as large. May be called
/// again to switch themes: widgets get a PaletteChange event, and windows repaint when all their parts have
/// the new sheet (ThemeSheets::settled).
void applyTheme(QApplication& application, Theme theme, double typeScale = 1);

/// The theme that was chosen last, of the settings; the system's where none was.
[[nodiscard]] Theme savedTheme();
void saveTheme(Theme theme);
/// Has no theme been chosen, so that the window looks as the system does?
[[nodiscard]] bool followsSystemTheme();
/// No theme is chosen any more.
void followSystemTheme();
/// Light or dark, as the system's own palette is.
[[nodiscard]] Theme systemTheme();

/// How large type is that the user wants, for the normal size 1; of the settings.
[[nodiscard]] double savedTypeScale();
void saveTypeScale(double scale);

}  // namespace geargraph::inline theme
