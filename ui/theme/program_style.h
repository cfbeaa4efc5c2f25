#pragma once

#include <QProxyStyle>

namespace geargraph::inline theme {

/// Fusion, and what no part of a window owns in the program's look: the lines between docks and the frames of
/// tips. They follow the palette, so that a main window needs no style sheet (ThemeSheets).
class ProgramStyle : public QProxyStyle {
  Q_OBJECT

 public:
  ProgramStyle();

  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace geargraph::inline theme
