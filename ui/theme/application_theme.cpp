#include "ui/theme/application_theme.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>

#include "ui/theme/style_sheet.h"

namespace geargraph {

QColor qColor(Color color) {
  return QColor(color.red, color.green, color.blue);
}

QColor qColor(ColorRole role, Theme theme) {
  return qColor(colorOf(role, theme));
}

Theme themeOf(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < 128 ? Theme::dark : Theme::light;
}

QPalette paletteOf(Theme theme) {
  const auto color = [theme](ColorRole role) { return qColor(role, theme); };
  QPalette palette;
  palette.setColor(QPalette::Window, color(ColorRole::panel));
  palette.setColor(QPalette::WindowText, color(ColorRole::ink));
  palette.setColor(QPalette::Base, color(ColorRole::sheet));
  palette.setColor(QPalette::AlternateBase, color(ColorRole::panel));
  palette.setColor(QPalette::Text, color(ColorRole::ink));
  palette.setColor(QPalette::PlaceholderText, color(ColorRole::secondary));
  palette.setColor(QPalette::Button, color(ColorRole::panel));
  palette.setColor(QPalette::ButtonText, color(ColorRole::ink));
  palette.setColor(QPalette::ToolTipBase, color(ColorRole::sheet));
  palette.setColor(QPalette::ToolTipText, color(ColorRole::ink));
  palette.setColor(QPalette::Highlight, color(ColorRole::accent));
  palette.setColor(QPalette::HighlightedText, color(ColorRole::sheet));
  palette.setColor(QPalette::Link, color(ColorRole::accent));
  palette.setColor(QPalette::Light, color(ColorRole::sheet));
  palette.setColor(QPalette::Dark, color(ColorRole::hairline));
  palette.setColor(QPalette::Mid, color(ColorRole::hairline));
  palette.setColor(QPalette::Midlight, color(ColorRole::hairline));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, color(ColorRole::secondary));
  }
  return palette;
}

void applyTheme(QApplication& application, Theme theme) {
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(paletteOf(theme));
  QFont font = application.font();
  font.setPixelSize(kBodyPixels);
  application.setFont(font);
  application.setStyleSheet(styleSheetOf(theme));
}

}  // namespace geargraph
