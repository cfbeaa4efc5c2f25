#pragma once

#include <QPalette>

class QPainter;
class QStyle;
class QStyleOption;
class QStyleOptionDockWidget;
class QStyleOptionMenuItem;
class QStyleOptionTab;
class QWidget;

namespace geargraph {

constexpr int kTabPadding = 13, kTabPaddingAbove = 6, kTabMark = 2;
constexpr int kDockTitlePadding = 16;

void drawToolBar(const QStyleOption& option, QPainter& painter, const QWidget* bar);
void drawToolBarSeparator(const QStyleOption& option, QPainter& painter);
void drawStatusBar(const QStyleOption& option, QPainter& painter);
void drawDockTitle(const QStyleOptionDockWidget& option, QPainter& painter, const QWidget* dock);
/// What lies between two docks and moves their border.
void drawDockSeparator(const QStyleOption& option, QPainter& painter);

void drawTab(const QStyleOptionTab& option, QPainter& painter);
/// The palette for the text of a tab.
[[nodiscard]] QPalette tabInks(const QStyleOptionTab& option);

void drawMenuBarItem(const QStyle& style, const QStyleOptionMenuItem& option, QPainter& painter);
/// The ground of an item that the pointer or a key has chosen, and of the icon of one that is checked.
void drawMenuItemGround(const QStyleOptionMenuItem& option, QPainter& painter);
/// The palette for an item whose ground has been drawn.
[[nodiscard]] QPalette menuInks(const QStyleOptionMenuItem& option);

}  // namespace geargraph
