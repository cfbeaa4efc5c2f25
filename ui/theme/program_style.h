#pragma once

#include <QProxyStyle>

namespace geargraph::inline theme {

/// Fusion with what follows the palette better than a style sheet: the lines between docks and the frames of
/// tips, so that a main window needs no sheet (ThemeSheets), and the indicators of check boxes and radio
/// buttons, which Fusion shades until they cannot be seen on a dark ground.
class ProgramStyle : public QProxyStyle {
  Q_OBJECT

 public:
  ProgramStyle();

  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                const QWidget* widget) const override;
  [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                              QStyleHintReturn* answer) const override;
  using QProxyStyle::polish;
  /// Controls without words of their own are told by their tips to those who do not see them.
  void polish(QWidget* widget) override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace geargraph::inline theme
