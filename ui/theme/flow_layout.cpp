#include "ui/theme/flow_layout.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace geargraph {
namespace {

/// Wide enough for what is in it, but no wider than the line. Text that wraps has a line of its own.
int widthIn(const QLayoutItem& item, int line) {
  if (item.hasHeightForWidth()) return line;
  return std::min(std::max(item.sizeHint().width(), item.minimumSize().width()), line);
}

int heightOf(const QLayoutItem& item, int width) {
  if (item.hasHeightForWidth()) return item.heightForWidth(width);
  return std::max(item.sizeHint().height(), item.minimumSize().height());
}

}  // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {}

FlowLayout::~FlowLayout() {
  while (QLayoutItem* item = FlowLayout::takeAt(0)) delete item;
}

void FlowLayout::addItem(QLayoutItem* item) {
  m_items.append(item);
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < m_items.size() ? m_items.takeAt(index) : nullptr;
}

int FlowLayout::heightForWidth(int width) const {
  return place(QRect(0, 0, width, 0), true);
}

QSize FlowLayout::sizeHint() const {
  const QMargins margins = contentsMargins();
  int width = 0;
  int height = 0;
  for (const QLayoutItem* item : m_items) {
    if (item->isEmpty()) continue;
    width += item->sizeHint().width() + (width > 0 ? spacing() : 0);
    height = std::max(height, heightOf(*item, item->sizeHint().width()));
  }
  return {width + margins.left() + margins.right(), height + margins.top() + margins.bottom()};
}

QSize FlowLayout::minimumSize() const {
  const QMargins margins = contentsMargins();
  QSize size;
  for (const QLayoutItem* item : m_items)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  return size.grownBy(margins);
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  place(area, false);
}

int FlowLayout::place(const QRect& area, bool isTrial) const {
  const QMargins margins = contentsMargins();
  const QRect inner = area.marginsRemoved(margins);
  QList<QLayoutItem*> line;
  int used = 0;
  int height = 0;
  int top = inner.top();
  const auto endLine = [&] {
    if (!isTrial) placeLine(line, inner, top, height);
    if (!line.isEmpty()) top += height + spacing();
    line.clear();
    used = height = 0;
  };
  for (QLayoutItem* item : m_items) {
    if (item->isEmpty()) continue;
    const int width = widthIn(*item, inner.width());
    if (!line.isEmpty() && used + spacing() + width > inner.width()) endLine();
    used += width + (line.isEmpty() ? 0 : spacing());
    height = std::max(height, heightOf(*item, width));
    line.append(item);
  }
  endLine();
  const int lines = std::max(0, top - inner.top() - spacing());
  return lines + margins.top() + margins.bottom();
}

/// Each in the middle of the line's height, so that texts of labels and buttons stand on one line.
void FlowLayout::placeLine(const QList<QLayoutItem*>& line, const QRect& area, int top, int height) const {
  const Qt::LayoutDirection direction =
      parentWidget() == nullptr ? Qt::LeftToRight : parentWidget()->layoutDirection();
  int left = area.left();
  for (QLayoutItem* item : line) {
    const int width = widthIn(*item, area.width());
    const QSize size(width, heightOf(*item, width));
    const QRect place(QPoint(left, top + (height - size.height()) / 2), size);
    item->setGeometry(QStyle::visualRect(direction, area, place));
    left += size.width() + spacing();
  }
}

}  // namespace geargraph

#include "moc_flow_layout.cpp"
