#include "ui/theme/application_theme.h"

#include <QApplication>
#include <algorithm>
#include <optional>
#include <utility>

#include "ui/settings/settings.h"
#include "ui/theme/painting_in_parts.h"
#include "ui/theme/program_style.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr std::pair<Theme, const char*> kThemeNames[] = {
    {Theme::light, "light"}, {Theme::dark, "dark"}, {Theme::highContrast, "highContrast"}};
const QString kThemeKey = QStringLiteral("theme");
const QString kTypeScaleKey = QStringLiteral("typeScale");
constexpr const char* kStyledProperty = "geargraphStyled";
/// Asking for it tells all widgets twice of another palette.
std::optional<Theme> knownSystemTheme;

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
  if (!knownSystemTheme) updateSystemTheme();
  return *knownSystemTheme;
}

void updateSystemTheme() {
  // The palette that was set hides the system's, which comes back when nothing is set.
  const QPalette set = QGuiApplication::palette();
  if (set.resolveMask() != 0) QGuiApplication::setPalette(QPalette());
  knownSystemTheme =
      QGuiApplication::palette().color(QPalette::Base).lightness() < 128 ? Theme::dark : Theme::light;
  if (set.resolveMask() != 0) QGuiApplication::setPalette(set);
}

double savedTypeScale() {
  constexpr double kLeast = 0.5, kMax = 3;
  return std::clamp(savedSetting(kTypeScaleKey, 1.0).toDouble(), kLeast, kMax);
}

void saveTypeScale(double scale) {
  saveSetting(kTypeScaleKey, scale);
}

void saveTheme(Theme theme) {
  for (const auto& [known, name] : kThemeNames) {
    if (known == theme) saveSetting(kThemeKey, QLatin1String(name));
  }
}

void applyTheme(QApplication& application, Theme theme, double typeScale, bool isLaidOutNext) {
  setTypeScale(typeScale);
  // Each of these polishes all widgets of the program again, so what stays as it is is not set.
  if (!application.property(kStyledProperty).toBool()) {
    application.setStyle(new ProgramStyle);
    application.setProperty(kStyledProperty, true);
  }
  IncrementalRestyle::instance().change(paletteOf(theme), isLaidOutNext);
}

}  // namespace geargraph
