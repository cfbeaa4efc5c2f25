#pragma once

#include <QHash>
#include <QIcon>
#include <QProxyStyle>

namespace geargraph::inline theme {

/// The Fusion style, with these drawn from the palette: the separators of docks and the frames of tooltips,
/// so that a main window needs no style sheet (ThemeSheets), the indicators of check boxes and radio buttons,
/// which in Fusion are invisible on a dark background, and the buttons of docks, which in Fusion are pictures
/// of one colour and size.
class ProgramStyle : public QProxyStyle {
  Q_OBJECT

 public:
  ProgramStyle();

  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                const QWidget* widget) const override;
  [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                              QStyleHintReturn* answer) const override;
  [[nodiscard]] QIcon standardIcon(StandardPixmap pixmap, const QStyleOption* option,
                                   const QWidget* widget) const override;
  using QProxyStyle::polish;
  /// Gives controls without text their tooltip as accessible name.
  void polish(QWidget* widget) override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;

 private:
  /// Fusion reads their files every time, a dozen for a file dialog. They are the same for all widgets.
  mutable QHash<StandardPixmap, QIcon> m_standardIcons;
};

}  // namespace geargraph::inline theme
