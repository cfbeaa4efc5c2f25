#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <limits>

namespace geargraph {

/// The time of the motion: it runs, pauses, or is set by the user. Angles are speeds times this time, so
/// every frame depends only on it.
class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(QObject* parent = nullptr);

  [[nodiscard]] double time() const { return m_time; }  ///< s
  [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
  [[nodiscard]] double speed() const { return m_speed; }  ///< seconds of motion per second; negative: reverse
  [[nodiscard]] double period() const { return m_period; }  ///< s; 0: none

  /// Limits the time to from..to (s), either of which may be infinite; at an end the motion reverses. Without
  /// finite ends the period applies.
  void setRange(double from, double to);
  [[nodiscard]] double from() const { return m_from; }
  [[nodiscard]] double to() const { return m_to; }
  [[nodiscard]] bool isLimited() const;

  /// Sets the period (s): the time is kept within 0..period, after which the motion repeats. 0: none.
  void setPeriod(double seconds);
  /// Pauses, and steps forwards (+1) or backwards (-1) by the motion of 1/20 s at the current speed.
  void step(int sense);
  /// Advances by this many seconds of real time.
  void advance(double seconds);

 public slots:
  void setPlaying(bool playing);
  void toggle() { setPlaying(!isPlaying()); }
  void setTime(double seconds);
  void setSpeed(double speed);

 signals:
  void timeChanged(double seconds);
  void playingChanged(bool playing);
  void speedChanged(double speed);
  void rangeChanged();
  /// The time reached the end of the range (true) or its beginning (false).
  void endReached(bool isEnd);

 private:
  double m_time = 0;
  double m_speed = 1;
  double m_period = 0;
  double m_from = -std::numeric_limits<double>::infinity();
  double m_to = std::numeric_limits<double>::infinity();
  QTimer m_timer;
  QElapsedTimer m_sinceFrame;
};

}  // namespace geargraph
