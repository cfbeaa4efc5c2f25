#pragma once

#include "ui/theme/theme_colors.h"

class QApplication;

namespace geargraph::inline theme {

/// Style, palette, style sheet and font of the whole program, type `typeScale` times as large. May be called
/// again to switch themes: widgets get a PaletteChange event, and windows repaint when all their parts have
/// the new sheet (ThemeSheets::settled).
void applyTheme(QApplication& application, Theme theme, double typeScale = 1);

/// The theme that was chosen last, of the settings; light at first.
[[nodiscard]] Theme savedTheme();
void saveTheme(Theme theme);

}  // namespace geargraph::inline theme
