#include "ui/theme/program_style.h"

#include <QAbstractButton>
#include <QPainter>
#include <QPolygonF>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTextDocumentFragment>
#include <algorithm>

#include "ui/theme/icons.h"
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

/// The border and the filling of a box or a circle that is on or off.
void setIndicatorInks(const QStyleOption& option, bool isOn, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  const auto color = [theme](ColorRole role) { return qColor(role, theme); };
  const bool isEnabled = (option.state & QStyle::State_Enabled) != 0;
  const bool isMarked = (option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus)) != 0;
  const ColorRole edge = !isEnabled         ? ColorRole::hairline
                         : isOn || isMarked ? ColorRole::accent
                                            : ColorRole::control;
  const QColor filling =
      !isOn ? color(ColorRole::sheet) : color(isEnabled ? ColorRole::accent : ColorRole::hairline);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color(edge), isMarked ? 2 : 1.4));  // a thinner circle would fade
  painter.setBrush(filling);
}

/// A square that is as large as there is room, on whole pixels.
QRectF squareIn(const QRect& room) {
  const int side = std::min(room.width(), room.height()) - 2;
  const QPoint corner = room.center() - QPoint(side / 2, side / 2);
  return QRectF(corner, QSizeF(side, side)).adjusted(0.5, 0.5, -0.5, -0.5);
}

void drawCheckBox(const QStyleOption& option, QPainter& painter) {
  const bool isPartly = (option.state & QStyle::State_NoChange) != 0;
  const bool isOn = isPartly || (option.state & QStyle::State_On) != 0;
  const QRectF box = squareIn(option.rect);
  painter.save();
  setIndicatorInks(option, isOn, painter);
  painter.drawRoundedRect(box, 3, 3);
  if (isOn) {
    const auto at = [&box](double right, double down) {
      return QPointF(box.x() + right * box.width(), box.y() + down * box.height());
    };
    painter.setPen(
        QPen(option.palette.color(QPalette::Base), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(isPartly ? QPolygonF({at(0.25, 0.5), at(0.75, 0.5)})
                                  : QPolygonF({at(0.22, 0.52), at(0.42, 0.73), at(0.78, 0.28)}));
  }
  painter.restore();
}

void drawRadioButton(const QStyleOption& option, QPainter& painter) {
  const bool isOn = (option.state & QStyle::State_On) != 0;
  const QRectF circle = squareIn(option.rect);
  painter.save();
  setIndicatorInks(option, isOn, painter);
  painter.drawEllipse(circle);
  if (isOn) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Base));
    painter.drawEllipse(circle.center(), circle.width() * 0.22, circle.width() * 0.22);
  }
  painter.restore();
}

bool isWordless(const QWidget& widget) {
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text().isEmpty();
  return widget.inherits("QAbstractSlider") || widget.inherits("QAbstractSpinBox") ||
         widget.inherits("QComboBox") || widget.inherits("QLineEdit") || widget.inherits("QAbstractItemView");
}

}  // namespace

ProgramStyle::ProgramStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int ProgramStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  if (metric == PM_DockWidgetSeparatorExtent) return kSeparatorPixels;
  if (metric == PM_ToolTipLabelFrameWidth) return kTipMargin;
  return QProxyStyle::pixelMetric(metric, option, widget);
}

int ProgramStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* answer) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, answer);
}

QIcon ProgramStyle::standardIcon(StandardPixmap pixmap, const QStyleOption* option,
                                 const QWidget* widget) const {
  if (option == nullptr || (pixmap != SP_TitleBarCloseButton && pixmap != SP_TitleBarNormalButton)) {
    QIcon& kept = m_standardIcons[pixmap];
    if (kept.isNull()) kept = QProxyStyle::standardIcon(pixmap, option, widget);
    return kept;
  }
  const QString name = pixmap == SP_TitleBarCloseButton ? QStringLiteral("close") : QStringLiteral("float");
  return icon(name, ColorRole::ink, themeOf(option->palette));
}

void ProgramStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  const QString tip = widget->toolTip();
  if (!widget->accessibleName().isEmpty() || tip.isEmpty() || !isWordless(*widget)) return;
  widget->setAccessibleName(Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText()
                                                     : tip);
}

void ProgramStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  switch (element) {
    case PE_IndicatorDockWidgetResizeHandle:
      return drawSeparator(*option, *painter);
    case PE_PanelTipLabel:
      return drawTip(*option, *painter);
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      return drawCheckBox(*option, *painter);
    case PE_IndicatorRadioButton:
      return drawRadioButton(*option, *painter);
    default:
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

}  // namespace geargraph::inline theme
