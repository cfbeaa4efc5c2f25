#include "ui/theme/program_style.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QListView>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPolygonF>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>
#include <QTableView>
#include <QTextDocumentFragment>
#include <algorithm>

#include "ui/theme/bar_painting.h"
#include "ui/theme/button_painting.h"
#include "ui/theme/field_painting.h"
#include "ui/theme/icons.h"
#include "ui/theme/looks.h"
#include "ui/theme/painting_in_parts.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kTipMargin = 6;

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
  const bool isEnabled = hasState(option, QStyle::State_Enabled);
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
  const bool isPartly = hasState(option, QStyle::State_NoChange);
  const bool isOn = isPartly || hasState(option, QStyle::State_On);
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
  const bool isOn = hasState(option, QStyle::State_On);
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

/// A view whose items show by themselves which one is current.
bool isBare(const QWidget* widget) {
  return qobject_cast<const QTableView*>(widget) != nullptr ||
         qobject_cast<const QListView*>(widget) != nullptr;
}

/// A line edit that stands on the ground of a spin box or a combo box.
bool isPartOfField(const QWidget* widget) {
  const QWidget* parent = widget != nullptr ? widget->parentWidget() : nullptr;
  return qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
         qobject_cast<const QComboBox*>(parent) != nullptr;
}

bool hasFrame(const QStyleOption* option) {
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  return frame != nullptr && frame->lineWidth > 0;
}

/// What a view, a page or a row of tabs stands on.
void setGround(QWidget& widget) {
  if (auto* tabs = qobject_cast<QTabBar*>(&widget)) {
    tabs->setDrawBase(false);
    tabs->setAttribute(Qt::WA_Hover);
    tabs->setBackgroundRole(QPalette::Window);
    tabs->setAutoFillBackground(true);
    tabs->setElideMode(Qt::ElideNone);  // where they do not fit, arrows scroll them
    tabs->setUsesScrollButtons(true);
  } else if (auto* page = qobject_cast<QScrollArea*>(&widget)) {
    page->setFrameShape(QFrame::NoFrame);
    page->viewport()->setBackgroundRole(QPalette::Base);
  } else if (auto* header = qobject_cast<QHeaderView*>(&widget)) {
    header->viewport()->setBackgroundRole(QPalette::Base);
  } else if (isBare(&widget)) {
    static_cast<QAbstractItemView&>(widget).setFrameShape(QFrame::NoFrame);
  } else if (qobject_cast<QScrollBar*>(&widget) != nullptr) {
    widget.setAttribute(Qt::WA_OpaquePaintEvent, false);  // what is below a list of cards shows through
  }
}

}  // namespace

ProgramStyle::ProgramStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int ProgramStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_DockWidgetSeparatorExtent:
      return 4;
    case PM_DockWidgetTitleMargin:
      return 6;
    case PM_ToolTipLabelFrameWidth:
      return kTipMargin;
    case PM_ToolBarFrameWidth:
      return 2;
    case PM_ToolBarItemMargin:
      return 6;
    case PM_ToolBarItemSpacing:
      return 4;
    case PM_ToolBarSeparatorExtent:
      return 13;
    case PM_MenuPanelWidth:
    case PM_MenuBarVMargin:
      return 1;
    case PM_MenuHMargin:
    case PM_MenuVMargin:
    case PM_MenuBarHMargin:
      return 4;
    case PM_TabBarTabHSpace:
      return 2 * kTabPadding;
    case PM_TabBarTabVSpace:
      return 2 * kTabPaddingAbove + kTabMark;
    case PM_TabBarTabOverlap:
    case PM_TabBarTabShiftVertical:
    case PM_TabBarTabShiftHorizontal:
    case PM_TabBarBaseOverlap:
    case PM_TabBarBaseHeight:
    case PM_ScrollView_ScrollBarSpacing:
    case PM_ScrollView_ScrollBarOverlap:
      return 0;
    case PM_ScrollBarExtent:
      return kScrollBarWidth;
    case PM_ScrollBarSliderMin:
      return kLeastScrollHandle;
    case PM_SliderLength:
    case PM_SliderThickness:
    case PM_SliderControlThickness:
      return kSliderHandle;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int ProgramStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* answer) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  if (hint == SH_Menu_Scrollable) return 1;  // else a high menu goes on in a second column
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
  IncrementalRestyle::dressPart(*widget);
  applyLook(*widget);
  setGround(*widget);
  const QString tip = widget->toolTip();
  if (!widget->accessibleName().isEmpty() || tip.isEmpty() || !isWordless(*widget)) return;
  widget->setAccessibleName(Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText()
                                                     : tip);
}

QSize ProgramStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                     const QWidget* widget) const {
  switch (type) {
    case CT_ToolButton:
      if (const ButtonForm* form = toolButtonForm(widget)) return roomFor(*form, contents);
      break;
    case CT_PushButton:
      return roomFor(pushButtonForm(lookOf(widget)), contents);
    case CT_LineEdit:
      return hasFrame(option) ? contents.grownBy(lineEditMargins(widget)) : contents;
    case CT_SpinBox:
      return contents.grownBy(kSpinBoxMargins);
    case CT_ComboBox:
      return contents.grownBy(kComboBoxMargins);
    case CT_MenuBarItem:
      return contents + QSize(20, 8);
    case CT_MenuItem: {
      const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
      const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
      if (item == nullptr || item->menuItemType == QStyleOptionMenuItem::Separator) return size;
      return size.expandedTo({0, item->fontMetrics.height() + 10});
    }
    default:
      break;
  }
  return QProxyStyle::sizeFromContents(type, option, contents, widget);
}

QRect ProgramStyle::subElementRect(SubElement element, const QStyleOption* option,
                                   const QWidget* widget) const {
  switch (element) {
    case SE_LineEditContents:
      if (hasFrame(option)) return option->rect.marginsRemoved(lineEditMargins(widget));
      break;
    case SE_TabWidgetTabContents:
      return subElementRect(SE_TabWidgetTabPane, option, widget);
    case SE_DockWidgetTitleBarText: {
      const QRect place = QProxyStyle::subElementRect(element, option, widget);
      return option->direction == Qt::LeftToRight ? place.adjusted(kDockTitlePadding, 0, 0, 0) : place;
    }
    default:
      break;
  }
  return QProxyStyle::subElementRect(element, option, widget);
}

QRect ProgramStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                   const QWidget* widget) const {
  if (control == CC_SpinBox) {
    if (const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option))
      return spinBoxPart(*box, part);
  } else if (control == CC_ComboBox && part != SC_ComboBoxListBoxPopup) {
    if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option))
      return comboBoxPart(*box, part);
  } else if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option)) {
    if (control == CC_ScrollBar) return scrollBarPart(*slider, part);
    if (control == CC_Slider && slider->orientation == Qt::Horizontal) return sliderPart(*slider, part);
  }
  return QProxyStyle::subControlRect(control, option, part, widget);
}

void ProgramStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  switch (element) {
    case PE_IndicatorDockWidgetResizeHandle:
      return drawDockSeparator(*option, *painter);
    case PE_PanelTipLabel:
      return drawTip(*option, *painter);
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      return drawCheckBox(*option, *painter);
    case PE_IndicatorRadioButton:
      return drawRadioButton(*option, *painter);
    case PE_IndicatorToolBarSeparator:
      return drawToolBarSeparator(*option, *painter);
    case PE_PanelStatusBar:
      return drawStatusBar(*option, *painter);
    case PE_PanelMenu:
      return painter->fillRect(option->rect, option->palette.color(QPalette::Base));
    case PE_FrameMenu:
      return drawBox(*painter, option->rect, {QColor(), option->palette.color(QPalette::Mid), 0});
    case PE_PanelScrollAreaCorner:
      return painter->fillRect(option->rect, option->palette.color(QPalette::Base));
    case PE_FrameStatusBarItem:
    case PE_FrameTabBarBase:
    case PE_FrameTabWidget:
      return;
    case PE_FrameFocusRect:
      // Their edges, or their delegates, show it.
      if (qobject_cast<const QPushButton*>(widget) != nullptr) return;
      if (isBare(widget)) return;
      break;
    case PE_PanelLineEdit: {
      const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
      if (frame == nullptr || isPartOfField(widget)) return;
      return drawLineEdit(*frame, *painter, widget);
    }
    case PE_Frame: {
      const auto* text = qobject_cast<const QPlainTextEdit*>(widget);
      const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
      if (text == nullptr || text->isReadOnly() || frame == nullptr) break;
      return drawLineEdit(*frame, *painter, widget);
    }
    case PE_Widget:
      drawFrameOf(lookOf(widget), *painter, *option);
      break;
    default:
      break;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void ProgramStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  switch (element) {
    case CE_ShapedFrame:
      if (const Look look = lookOf(widget); look != Look::none) {
        QStyleOption all = *option;
        all.rect = widget->rect();  // a frame itself leaves out the margins
        drawFrameOf(look, *painter, all);
      }
      break;
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
      return painter->fillRect(option->rect, option->palette.color(QPalette::Base));
    case CE_ToolBar:
      return drawToolBar(*option, *painter, widget);
    case CE_DockWidgetTitle:
      if (const auto* title = qstyleoption_cast<const QStyleOptionDockWidget*>(option))
        return drawDockTitle(*title, *painter, widget);
      break;
    case CE_TabBarTabShape:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) return drawTab(*tab, *painter);
      break;
    case CE_TabBarTabLabel:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
        QStyleOptionTab label = *tab;
        label.palette = tabInks(*tab);
        return QProxyStyle::drawControl(element, &label, painter, widget);
      }
      break;
    case CE_MenuBarEmptyArea:
      return painter->fillRect(option->rect, option->palette.color(QPalette::Window));
    case CE_MenuBarItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
        return drawMenuBarItem(*this, *item, *painter);
      break;
    case CE_MenuItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option)) {
        drawMenuItemGround(*item, *painter);
        QStyleOptionMenuItem content = *item;
        content.palette = menuInks(*item);
        if (!item->icon.isNull())
          content.checkType = QStyleOptionMenuItem::NotCheckable;  // its ground shows it
        return QProxyStyle::drawControl(element, &content, painter, widget);
      }
      break;
    case CE_PushButtonBevel:
      if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option))
        return drawPushButtonGround(*this, *button, *painter, lookOf(widget));
      break;
    default:
      break;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void ProgramStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                      QPainter* painter, const QWidget* widget) const {
  if (control == CC_ToolButton) {
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    const ButtonForm* form = toolButtonForm(widget);
    if (button != nullptr && form != nullptr) return drawToolButton(*this, *button, *painter, *widget, *form);
  } else if (control == CC_SpinBox) {
    if (const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option))
      return drawSpinBox(*this, *box, *painter, widget);
  } else if (control == CC_ComboBox) {
    if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option))
      return drawComboBox(*box, *painter);
  } else if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option)) {
    if (control == CC_ScrollBar) return drawScrollBar(*slider, *painter, widget);
    if (control == CC_Slider && slider->orientation == Qt::Horizontal) return drawSlider(*slider, *painter);
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
}

}  // namespace geargraph

#include "moc_program_style.cpp"
