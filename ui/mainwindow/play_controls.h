#pragma once

#include <QPointer>
#include <QWidget>

#include "ui/view3d/playback.h"

class QLabel;
class QSlider;
class QToolButton;

namespace geargraph {

/// Play or pause, and the playback speed: the middle of the slider is the inputs' own speed, the ends are
/// eight times slower and faster. A double click on the slider resets it to 1.0×.
class PlayControls : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kFastest = 8;

  PlayControls(Playback* playback, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void updateButton();
  void showSpeed();

  QPointer<Playback> m_playback;  ///< destroyed before the tool bar when a window is destroyed
  QToolButton* m_play;
  QSlider* m_slider;
  QLabel* m_speed;
};

/// "1.0×", "0.25×": a speed for the tool bar.
[[nodiscard]] QString printedSpeed(double speed);

}  // namespace geargraph
