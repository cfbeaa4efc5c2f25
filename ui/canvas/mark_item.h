#pragma once

#include <QGraphicsItem>

#include "core/drawing/display_list.h"

namespace geargraph {

/// Some marks of a display list on a scene: a node, an arrow, a halo, or what lies over the drawing. Picking
/// is not its business: the view asks the outlines of the display list.
class MarkItem final : public QGraphicsItem {
 public:
  explicit MarkItem(double depth);

  /// Shows other marks; repaints only if they differ.
  void setMarks(std::vector<Mark> marks);
  void setTheme(Theme theme);

  [[nodiscard]] QRectF boundingRect() const override { return m_bounds; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::vector<Mark> m_marks;
  QRectF m_bounds;
  Theme m_theme = Theme::light;
};

}  // namespace geargraph
