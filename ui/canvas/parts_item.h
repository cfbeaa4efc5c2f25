#pragma once

#include <QGraphicsItem>
#include <QRegion>

#include "ui/canvas/sheet_parts.h"

namespace geargraph::inline canvas {

/// All parts of a drawing as one item of the scene, of which it paints what can be seen. An item for each of
/// thousands of parts would cost more than the parts: their order, their areas and their removal are kept by
/// lists of the scene.
class PartsItem final : public QGraphicsItem {
 public:
  /// In the colours of `theme` as it is when the item is painted: the scene's, which repaints when it
  /// changes.
  explicit PartsItem(const Theme& theme);

  /// After a change, update() the area that it returns.
  [[nodiscard]] SheetParts& parts() { return m_parts; }
  [[nodiscard]] const SheetParts& parts() const { return m_parts; }
  /// Where parts may be.
  void setArea(const QRectF& area);
  /// What of the viewport is to be painted next; else all of the exposed rectangle is.
  void setExposed(const QRegion& viewport) { m_exposed = viewport; }

  [[nodiscard]] QRectF boundingRect() const override { return m_area; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  SheetParts m_parts;
  QRectF m_area;
  QRegion m_exposed;
  const Theme& m_theme;
};

}  // namespace geargraph::inline canvas
