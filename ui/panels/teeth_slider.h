#pragma once

#include <QSlider>
#include <optional>

namespace geargraph::inline panels {

/// A slider for the teeth of a gear, in whole numbers over those that gears mostly have, and twice as many as
/// the gear has. It shows what the document has: teeth that are refused put it back. Esc in a drag puts back.
class TeethSlider : public QSlider {
  Q_OBJECT

 public:
  explicit TeethSlider(QWidget* parent = nullptr);

  /// The document's number; none: of several gears that differ, when nothing can be slid.
  void showTeeth(const std::optional<int>& teeth);

 signals:
  void started();        ///< what follows until the next one is one gesture
  void slid(int teeth);  ///< while it is dragged too
  void putBack();        ///< the gesture is given up

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void follow(int x);

  bool m_isGivenUp = false;  ///< the drag under way
};

}  // namespace geargraph::inline panels
