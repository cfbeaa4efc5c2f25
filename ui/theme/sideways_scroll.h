#pragma once

#include <QScrollArea>

class QToolButton;

namespace geargraph {

/// A strip of controls with its natural height that scrolls horizontally if it is too wide, so that it does
/// not force a minimum width on a panel. An arrow at an edge beyond which there is more takes the place of a
/// scroll bar, which would be as high as the strip.
class SidewaysScroll : public QScrollArea {
  Q_OBJECT

 public:
  explicit SidewaysScroll(QWidget* strip, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  QToolButton* makeArrow(int way, const QString& tip);
  void placeArrows();

  QToolButton* m_left;
  QToolButton* m_right;
};

}  // namespace geargraph
