#include "ui/theme/program_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "ui/theme/theme_colors.h"

namespace geargraph::inline theme {
namespace {

constexpr int kSeparatorPixels = 4;
constexpr int kTipMargin = 6;

void drawSeparator(const QStyleOption& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  const QRect area = option.rect;
  const bool isHovered = (option.state & QStyle::State_MouseOver) != 0;
  painter.fillRect(area, qColor(isHovered ? ColorRole::halo : ColorRole::panel, theme));
  if (isHovered) return;
  const bool isHorizontal = (option.state & QStyle::State_Horizontal) != 0;
  const QRect line(area.topLeft(), isHorizontal ? QSize(area.width(), 1) : QSize(1, area.height()));
  painter.fillRect(line, qColor(ColorRole::hairline, theme));
}

void drawTip(const QStyleOption& option, QPainter& painter) {
  painter.fillRect(option.rect, option.palette.color(QPalette::ToolTipBase));
  painter.setPen(option.palette.color(QPalette::Mid));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
}

}  // namespace

ProgramStyle::ProgramStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int ProgramStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  if (metric == PM_DockWidgetSeparatorExtent) return kSeparatorPixels;
  if (metric == PM_ToolTipLabelFrameWidth) return kTipMargin;
  return QProxyStyle::pixelMetric(metric, option, widget);
}

void ProgramStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  if (element == PE_IndicatorDockWidgetResizeHandle) {
    drawSeparator(*option, *painter);
  } else if (element == PE_PanelTipLabel) {
    drawTip(*option, *painter);
  } else {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

}  // namespace geargraph::inline theme
