#pragma once

#include <QImage>
#include <QWidget>

#include "core/presentation/diagrams/chain_drawing.h"

namespace geargraph {

/// Paints the drawing of a chain as large as an area has room for. Thread-safe.
void paintChain(QPainter& painter, const DisplayList& drawing, const QRectF& area, Theme theme);

/// The digraph of one chain, or another picture of it.
class ChainPicture final : public QWidget {
  Q_OBJECT

 public:
  explicit ChainPicture(QWidget* parent = nullptr);

  /// `description` is for screen readers.
  void setDrawing(DisplayList drawing, const QString& description);
  void setImage(QImage image, const QString& description);
  [[nodiscard]] const DisplayList& drawing() const { return m_drawing; }
  [[nodiscard]] const QImage& image() const { return m_image; }
  [[nodiscard]] QSize sizeHint() const override { return {220, 180}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DisplayList m_drawing;
  QImage m_image;  ///< in place of a drawing
};

}  // namespace geargraph
