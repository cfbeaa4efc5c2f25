#include "ui/theme/theme_colors.h"

#include <QCoreApplication>
#include <QVariant>

namespace geargraph {
namespace {

constexpr int kBodyPixels = 13;
constexpr int kSmallPixels = 12;
constexpr const char* kScaleProperty = "geargraphTypeScale";

}  // namespace

QColor qColor(Color color) {
  return QColor(color.red, color.green, color.blue);
}

QColor qColor(ColorRole role, Theme theme) {
  return qColor(colorOf(role, theme));
}

Theme themeOf(const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base);
  if (base == qColor(ColorRole::sheet, Theme::highContrast)) return Theme::highContrast;
  return base.lightness() < 128 ? Theme::dark : Theme::light;
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

int scaledPixels(int pixels) {
  const double scale = QCoreApplication::instance()->property(kScaleProperty).toDouble();
  return scale > 0 ? qRound(pixels * scale) : pixels;
}

int bodyPixels() {
  return scaledPixels(kBodyPixels);
}

int smallPixels() {
  return scaledPixels(kSmallPixels);
}

void setTypeScale(double scale) {
  QCoreApplication::instance()->setProperty(kScaleProperty, scale);
}

}  // namespace geargraph
