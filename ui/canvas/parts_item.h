#pragma once

#include <QGraphicsItem>
#include <QRegion>

#include "ui/canvas/sheet_parts.h"

namespace geargraph {

/// All parts of a drawing as one item of the scene, which paints the visible ones. Thousands of single items
/// would cost more than the parts, because QGraphicsScene keeps lists of their order and areas.
class PartsItem final : public QGraphicsItem {
 public:
  /// `theme` is read when painting: that of the scene, which repaints when it changes. It outlives the item.
  explicit PartsItem(const Theme& theme);

  /// After a change, update() the area that it returns.
  [[nodiscard]] SheetParts& parts() { return m_parts; }
  [[nodiscard]] const SheetParts& parts() const { return m_parts; }
  /// Sets the area in which parts can be.
  void setArea(const QRectF& area);
  /// Sets the region of the viewport that is painted next; without it the whole exposed rectangle is painted.
  void setExposed(const QRegion& viewport) { m_exposed = viewport; }

  [[nodiscard]] QRectF boundingRect() const override { return m_area; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  SheetParts m_parts;
  QRectF m_area;
  QRegion m_exposed;
  const Theme& m_theme;
};

}  // namespace geargraph
