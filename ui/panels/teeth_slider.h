#pragma once

#include <QSlider>
#include <optional>

namespace geargraph {

/// A slider for the number of teeth of a gear, over the usual range and at least up to twice the gear's
/// number. It shows the document's number: a rejected number moves it back. Esc during a drag restores the
/// number at its start.
class TeethSlider : public QSlider {
  Q_OBJECT

 public:
  explicit TeethSlider(QWidget* parent = nullptr);

  /// Shows the document's number; std::nullopt: several gears that differ, which disables the slider.
  void showTeeth(const std::optional<int>& teeth);

 signals:
  void started();        ///< edits until the next one are one gesture
  void slid(int teeth);  ///< also during a drag
  void putBack();        ///< the gesture was cancelled

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void follow(int x);

  bool m_isGivenUp = false;  ///< the current drag was cancelled
};

}  // namespace geargraph
