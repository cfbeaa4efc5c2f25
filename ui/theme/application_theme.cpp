#include "ui/theme/application_theme.h"

#include <QApplication>
#include <QFont>
#include <QSettings>
#include <QToolTip>
#include <utility>

#include "ui/theme/program_style.h"
#include "ui/theme/style_sheet.h"
#include "ui/theme/theme_sheets.h"

namespace geargraph::inline theme {
namespace {

constexpr std::pair<Theme, const char*> kThemeNames[] = {
    {Theme::light, "light"}, {Theme::dark, "dark"}, {Theme::highContrast, "highContrast"}};
const QString kThemeKey = QStringLiteral("theme");
constexpr const char* kStyledProperty = "geargraphStyled";

}  // namespace

Theme savedTheme() {
  const QString name = QSettings().value(kThemeKey).toString();
  for (const auto& [theme, saved] : kThemeNames) {
    if (name == QLatin1String(saved)) return theme;
  }
  return Theme::light;
}

void saveTheme(Theme theme) {
  for (const auto& [known, name] : kThemeNames) {
    if (known == theme) QSettings().setValue(kThemeKey, QLatin1String(name));
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
  ThemeSheets::instance().setSheet(styleSheetOf(theme));
}

}  // namespace geargraph::inline theme
