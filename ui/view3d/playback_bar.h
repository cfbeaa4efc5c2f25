#pragma once

#include <QWidget>

#include "ui/view3d/playback.h"

class QLabel;
class QSlider;
class QToolButton;

namespace geargraph {

/// Play and pause, a scrub bar over one period (over a minute where there is none), and the time.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlaybackBar(Playback* playback, QWidget* parent = nullptr);

  /// The period, or the stretch of time that the bar shows without one.
  [[nodiscard]] double span() const;
  void setDark(bool dark);
  void refresh();  ///< after another period

 private:
  void showTime();

  Playback* m_playback;
  QToolButton* m_play;
  QSlider* m_scrub;
  QLabel* m_time;
};

}  // namespace geargraph
