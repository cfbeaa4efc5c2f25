#pragma once

#include <QHash>
#include <QIcon>
#include <QProxyStyle>

namespace geargraph {

/// The Fusion style in the colours and forms of the program: bars, tabs, menus, buttons, fields, indicators
/// and what has a look (Look). They are drawn from the palette: with a style sheet, each change of the theme
/// and each drag of a dock would match its rules with all widgets again, 10 to 30 ms for a dock.
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
  /// Applies looks, and gives controls without text their tooltip as accessible name.
  void polish(QWidget* widget) override;
  [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                       const QWidget* widget) const override;
  [[nodiscard]] QRect subElementRect(SubElement element, const QStyleOption* option,
                                     const QWidget* widget) const override;
  [[nodiscard]] QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                     SubControl part, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;

 private:
  /// Fusion reads their files every time, a dozen for a file dialog. They are the same for all widgets.
  mutable QHash<StandardPixmap, QIcon> m_standardIcons;
};

}  // namespace geargraph
