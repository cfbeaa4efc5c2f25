#pragma once

#include <QWidget>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// A drawing of core's, as large as there is room.
class DrawingPreview final : public QWidget {
  Q_OBJECT

 public:
  explicit DrawingPreview(QWidget* parent = nullptr);

  void setDrawing(DisplayList drawing);
  [[nodiscard]] const DisplayList& drawing() const { return m_drawing; }
  [[nodiscard]] QSize sizeHint() const override { return {190, 190}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DisplayList m_drawing;
};

}  // namespace geargraph
