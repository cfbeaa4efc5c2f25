#pragma once

#include <QAbstractSlider>

namespace geargraph {

/// A slider with zero in the middle. The part between zero and the handle is filled to show the direction.
/// The arrow keys step, Home sets it to zero.
class SpeedSlider : public QAbstractSlider {
  Q_OBJECT

 public:
  static constexpr int kSteps = 200;  ///< from zero to each end

  explicit SpeedSlider(QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {200, 22}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {80, 22}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] double xOf(int steps) const;
  void follow(double x);
};

}  // namespace geargraph
