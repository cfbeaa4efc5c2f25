#pragma once

#include <QWidget>
#include <optional>
#include <utility>

#include "core/presentation/drawing/palette.h"
#include "ui/view3d/playback.h"

class QLabel;
class QSlider;
class QToolButton;

namespace geargraph {

/// The controls of the playback: play and pause, single steps, a scrub bar over span(), the time, and the
/// speed with its direction.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlaybackBar(Playback* playback, QWidget* parent = nullptr);

  /// The length of time that the bar shows, in s: the range between the limits of joints, else the period,
  /// else a minute.
  [[nodiscard]] double span() const;
  [[nodiscard]] double start() const;  ///< s, at the left end of the bar
  void setDark(bool dark);
  void refresh();  ///< to be called when the period changes
  /// Sets whether a trajectory is played; then a button ends it.
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
  std::optional<std::pair<bool, Theme>> m_icon;  ///< shown icon: playing, for which picture
  QToolButton* m_play;
  QSlider* m_scrub;
  QLabel* m_time;
  QToolButton* m_endTrajectory;
  QString m_longest;  ///< longest time text of this period, for the label's width
  QToolButton* m_speed;
};

}  // namespace geargraph
