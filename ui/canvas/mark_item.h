#pragma once

#include <QGraphicsItem>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// Some marks of a display list on a scene: a node, an arrow, a halo, or the overlay. Not used for picking,
/// which uses the outlines of the display list.
class MarkItem final : public QGraphicsItem {
 public:
  /// `theme` is read when painting: that of the scene, which repaints when it changes. It outlives the item.
  MarkItem(double depth, const Theme& theme);

  /// Shows other marks; repaints only if they differ.
  void setMarks(std::vector<Mark> marks);

  [[nodiscard]] QRectF boundingRect() const override { return m_bounds; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::vector<Mark> m_marks;
  QRectF m_bounds;
  const Theme& m_theme;
};

}  // namespace geargraph
