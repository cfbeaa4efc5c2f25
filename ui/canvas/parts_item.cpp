#include "ui/canvas/parts_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "ui/canvas/mark_painter.h"

namespace geargraph {

PartsItem::PartsItem(const Theme& theme) : m_theme(theme) {
  setFlag(ItemUsesExtendedStyleOption);  // for the exposed rectangle
  setAcceptedMouseButtons(Qt::NoButton);
}

void PartsItem::setArea(const QRectF& area) {
  if (area == m_area) return;
  prepareGeometryChange();
  m_area = area;
}

void PartsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const QTransform onDevice = painter->worldTransform();
  const double scale = QStyleOptionGraphicsItem::levelOfDetailFromTransform(onDevice);
  const QRectF exposed = option->exposedRect;
  const bool isScattered = m_exposed.rectCount() > 1;
  for (const auto& [depth, layer] : m_parts.layers()) {
    for (const SheetParts::Part& part : layer) {
      if (part.marks.empty() || !part.bounds.intersects(exposed)) continue;
      if (isScattered && !m_exposed.intersects(onDevice.mapRect(part.bounds).toAlignedRect())) continue;
      paintMarks(*painter, part.marks, m_theme, scale);
    }
  }
}

}  // namespace geargraph
