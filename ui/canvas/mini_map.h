#pragma once

#include <QWidget>

#include "ui/service/turns.h"

namespace geargraph {

class DrawingView;

/// All of a drawing in a corner of its view, with a frame around what is in sight; shown while the drawing
/// does not fit. A click or drag moves the view there.
class MiniMap : public QWidget {
  Q_OBJECT

 public:
  /// Belongs to the view.
  explicit MiniMap(DrawingView* view);

  [[nodiscard]] QSize sizeHint() const override { return {148, 104}; }
  /// What is in sight, in the map's own pixels.
  [[nodiscard]] QRectF frame() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void follow();
  void showPlace(QPointF place);
  [[nodiscard]] QRectF sight() const;  ///< sheet units
  /// From the sheet to the map.
  [[nodiscard]] QTransform toMap() const;

  DrawingView* m_view;
  QRectF m_all;    ///< the drawing, sheet units
  QRectF m_sight;  ///< shown last
  CoalescedTask m_turn{this, [this] { follow(); }};
};

}  // namespace geargraph
