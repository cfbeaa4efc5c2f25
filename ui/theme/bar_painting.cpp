#include "ui/theme/bar_painting.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QWidget>

#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

void drawLineBelow(const QStyleOption& option, QPainter& painter) {
  const QRect& all = option.rect;
  painter.fillRect(QRect(all.left(), all.bottom(), all.width(), 1),
                   qColor(ColorRole::hairline, themeOf(option.palette)));
}

bool isChosen(const QStyleOptionMenuItem& option) {
  return hasState(option, QStyle::State_Selected) && hasState(option, QStyle::State_Enabled) &&
         option.menuItemType != QStyleOptionMenuItem::Separator;
}

}  // namespace

void drawToolBar(const QStyleOption& option, QPainter& painter, const QWidget* bar) {
  const Theme theme = themeOf(option.palette);
  const bool isNotice = lookOf(bar) == Look::banner;
  painter.fillRect(option.rect, isNotice ? chosenColor(theme) : qColor(ColorRole::sheet, theme));
  drawLineBelow(option, painter);
}

void drawToolBarSeparator(const QStyleOption& option, QPainter& painter) {
  const QRect& all = option.rect;
  constexpr int kInset = 4;
  const QRect line = hasState(option, QStyle::State_Horizontal)
                         ? QRect(all.center().x(), all.top() + kInset, 1, all.height() - 2 * kInset)
                         : QRect(all.left() + kInset, all.center().y(), all.width() - 2 * kInset, 1);
  painter.fillRect(line, qColor(ColorRole::hairline, themeOf(option.palette)));
}

void drawStatusBar(const QStyleOption& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  painter.fillRect(option.rect, qColor(ColorRole::panel, theme));
  painter.fillRect(QRect(option.rect.topLeft(), QSize(option.rect.width(), 1)),
                   qColor(ColorRole::hairline, theme));
}

void drawDockTitle(const QStyleOptionDockWidget& option, QPainter& painter, const QWidget* dock) {
  const Theme theme = themeOf(option.palette);
  painter.fillRect(option.rect, qColor(ColorRole::panel, theme));
  drawLineBelow(option, painter);
  if (option.title.isEmpty() || dock == nullptr) return;
  const QRect room = dock->style()->subElementRect(QStyle::SE_DockWidgetTitleBarText, &option, dock);
  painter.setFont(dock->font());  // Qt has set that of the system, which the size of type does not change
  const QString text = painter.fontMetrics().elidedText(option.title, Qt::ElideRight, room.width());
  dock->style()->drawItemText(&painter, room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic,
                              option.palette, true, text, QPalette::WindowText);
}

void drawDockSeparator(const QStyleOption& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  const QRect area = option.rect;
  const bool isHovered = hasState(option, QStyle::State_MouseOver);
  painter.fillRect(area, qColor(isHovered ? ColorRole::halo : ColorRole::panel, theme));
  if (isHovered) return;
  const bool isHorizontal = hasState(option, QStyle::State_Horizontal);
  const QRect line(area.topLeft(), isHorizontal ? QSize(area.width(), 1) : QSize(1, area.height()));
  painter.fillRect(line, qColor(ColorRole::hairline, theme));
}

void drawTab(const QStyleOptionTab& option, QPainter& painter) {
  if (!hasState(option, QStyle::State_Selected)) return;
  const Theme theme = themeOf(option.palette);
  painter.fillRect(option.rect, qColor(ColorRole::sheet, theme));
  painter.fillRect(QRect(option.rect.topLeft(), QSize(option.rect.width(), kTabMark)),
                   qColor(ColorRole::accent, theme));
}

QPalette tabInks(const QStyleOptionTab& option) {
  const bool isBright = hasState(option, QStyle::State_Selected) || hasState(option, QStyle::State_MouseOver);
  QPalette inks = option.palette;
  inks.setColor(QPalette::WindowText,
                qColor(isBright ? ColorRole::ink : ColorRole::secondary, themeOf(option.palette)));
  return inks;
}

void drawMenuBarItem(const QStyle& style, const QStyleOptionMenuItem& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  painter.fillRect(option.rect, qColor(ColorRole::panel, theme));
  if (isChosen(option)) drawBox(painter, option.rect, {qColor(ColorRole::halo, theme), QColor()});
  int alignment = Qt::AlignCenter | Qt::TextShowMnemonic | Qt::TextDontClip | Qt::TextSingleLine;
  if (style.styleHint(QStyle::SH_UnderlineShortcut, &option) == 0) alignment |= Qt::TextHideMnemonic;
  style.drawItemText(&painter, option.rect, alignment, option.palette,
                     hasState(option, QStyle::State_Enabled), option.text, QPalette::WindowText);
}

void drawMenuItemGround(const QStyleOptionMenuItem& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  painter.fillRect(option.rect, qColor(ColorRole::sheet, theme));
  if (isChosen(option)) drawBox(painter, option.rect, {qColor(ColorRole::halo, theme), QColor()});
  if (!option.checked || option.icon.isNull()) return;
  const int side = option.rect.height() - 4;
  const QRect place(option.rect.topLeft() + QPoint(4, 2), QSize(side, side));
  drawBox(painter, QStyle::visualRect(option.direction, option.rect, place),
          {chosenColor(theme), qColor(ColorRole::accent, theme)});
}

QPalette menuInks(const QStyleOptionMenuItem& option) {
  const Theme theme = themeOf(option.palette);
  QPalette inks = option.palette;
  inks.setColor(QPalette::Highlight, Qt::transparent);
  inks.setColor(QPalette::HighlightedText, qColor(ColorRole::ink, theme));
  const QColor disabled = disabledColor(theme);
  for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
    inks.setColor(QPalette::Disabled, role, disabled);
  return inks;
}

}  // namespace geargraph
