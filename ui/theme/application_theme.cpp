#include "ui/theme/application_theme.h"

#include <QApplication>
#include <QFont>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "ui/settings/settings.h"
#include "ui/theme/program_style.h"
#include "ui/theme/style_sheet.h"
#include "ui/theme/theme_sheets.h"

namespace geargraph::inline theme {
namespace {

constexpr std::pair<Theme, const char*> kThemeNames[] = {
    {Theme::light, "light"}, {Theme::dark, "dark"}, {Theme::highContrast, "highContrast"}};
const QString kThemeKey = QStringLiteral("theme");
const QString kTypeScaleKey = QStringLiteral("typeScale");
constexpr const char* kStyledProperty = "geargraphStyled";

}  // namespace

Theme savedTheme() {
  const QString name = savedSetting(kThemeKey).toString();
  for (const auto& [theme, saved] : kThemeNames) {
    if (name == QLatin1String(saved)) return theme;
  }
  return systemTheme();
}

bool followsSystemTheme() {
  return !isSettingSaved(kThemeKey);
}

void followSystemTheme() {
  removeSetting(kThemeKey);
}

Theme systemTheme() {
  // The palette that was set hides the system's, which comes back when nothing is set.
  const QPalette set = QGuiApplication::palette();
  if (set.resolveMask() == 0) return themeOf(set);
  QGuiApplication::setPalette(QPalette());
  const Theme theme =
      QGuiApplication::palette().color(QPalette::Base).lightness() < 128 ? Theme::dark : Theme::light;
  QGuiApplication::setPalette(set);
  return theme;
}

double savedTypeScale() {
  constexpr double kLeast = 0.5, kMost = 3;
  return std::clamp(savedSetting(kTypeScaleKey, 1.0).toDouble(), kLeast, kMost);
}

void saveTypeScale(double scale) {
  saveSetting(kTypeScaleKey, scale);
}

void saveTheme(Theme theme) {
  for (const auto& [known, name] : kThemeNames) {
    if (known == theme) saveSetting(kThemeKey, QLatin1String(name));
  }
}

void applyTheme(QApplication& application, Theme theme, double typeScale) {
  setTypeScale(typeScale);
  // Each of these polishes all widgets of the program again, so what stays as it is is not set.
  if (!application.property(kStyledProperty).toBool()) {
    application.setStyle(new ProgramStyle);
    application.setProperty(kStyledProperty, true);
  }
  if (QFont font = application.font(); font.pixelSize() != bodyPixels()) {
    font.setPixelSize(bodyPixels());
    application.setFont(font);
  }
  const QPalette palette = paletteOf(theme);
  application.setPalette(palette);
  QToolTip::setPalette(palette);
  const bool isLasting = typeScale == savedTypeScale();  // unlike that of a presentation
  ThemeSheets::instance().setSheet(styleSheetOf(theme), isLasting);
}

}  // namespace geargraph::inline theme
