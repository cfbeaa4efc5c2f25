#pragma once

#include <QWidget>

#include "ui/view3d/playback.h"

class QLabel;
class QSlider;
class QToolButton;

namespace geargraph {

/// Play and pause, single steps, a scrub bar over one period (over a minute where there is none), the time,
/// and the speed with its direction.
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
  void showSpeed();
  void makeSpeedMenu();
  QToolButton* addButton(const char* name, const QString& text, const QString& tip);

  Playback* m_playback;
  bool m_dark = false;
  QToolButton* m_play;
  QSlider* m_scrub;
  QLabel* m_time;
  QToolButton* m_speed;
};

}  // namespace geargraph
