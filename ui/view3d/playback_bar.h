#pragma once

#include <QWidget>
#include <optional>
#include <utility>

#include "ui/view3d/playback.h"

class QLabel;
class QSlider;
class QToolButton;

namespace geargraph::inline view3d {

/// Play and pause, single steps, a scrub bar over one period (over a minute where there is none, between the
/// limits of joints where they have any), the time,
/// and the speed with its direction.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlaybackBar(Playback* playback, QWidget* parent = nullptr);

  /// The length of time that the bar shows: what limits of joints leave, else the period, else a minute.
  [[nodiscard]] double span() const;
  [[nodiscard]] double start() const;  ///< the time at its left end
  void setDark(bool dark);
  void refresh();  ///< after another period
  /// Does the time run along a trajectory? Then a button ends that.
  void setAlongTrajectory(bool along);

 signals:
  void trajectoryEnded();  ///< by the button

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QString timeText(double time) const;
  void showTime();
  void showSpeed();
  void makeSpeedMenu();
  QToolButton* addButton(const char* name, const QString& text, const QString& tip);

  Playback* m_playback;
  bool m_dark = false;
  std::optional<std::pair<bool, bool>> m_icon;  ///< of which state: playing, dark
  QToolButton* m_play;
  QSlider* m_scrub;
  QLabel* m_time;
  QToolButton* m_endTrajectory;
  QString m_longest;  ///< text of this period that the label of the time has room for
  QToolButton* m_speed;
};

}  // namespace geargraph::inline view3d
