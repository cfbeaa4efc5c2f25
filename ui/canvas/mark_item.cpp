#include "ui/canvas/mark_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "ui/canvas/mark_painter.h"

namespace geargraph {

MarkItem::MarkItem(double depth, const Theme& theme) : m_theme(theme) {
  setZValue(depth);
  setAcceptedMouseButtons(Qt::NoButton);
}

void MarkItem::setMarks(std::vector<Mark> marks) {
  if (marks == m_marks) return;
  prepareGeometryChange();
  m_marks = std::move(marks);
  m_bounds = {};
  for (const Mark& mark : m_marks) m_bounds |= toQRect(extentOf(mark).grown(1));
  update();
}

void MarkItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const double scale = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  paintMarks(*painter, m_marks, m_theme, scale);
}

}  // namespace geargraph
