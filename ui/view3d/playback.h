#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <limits>

namespace geargraph::inline view3d {

/// The time of the motion: it runs at a speed, stands still, or is set by hand. Angles are speeds times this
/// time, so every frame is a function of it.
class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(QObject* parent = nullptr);

  [[nodiscard]] double time() const { return m_time; }  ///< s
  [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
  [[nodiscard]] double speed() const { return m_speed; }  ///< seconds of motion a second; negative runs back
  [[nodiscard]] double period() const { return m_period; }  ///< s; 0 where there is none

  /// Time stays from..to, either of which may be infinite; a motion that runs into an end turns round.
  /// Without ends the period counts.
  void setRange(double from, double to);
  [[nodiscard]] double from() const { return m_from; }
  [[nodiscard]] double to() const { return m_to; }
  [[nodiscard]] bool isLimited() const;

  /// With a period, time stays within 0..period: the motion begins again as it was.
  void setPeriod(double seconds);
  /// Pauses, and goes on (+1) or back (-1) by what runs in a twentieth of a second: small steps in slow
  /// motion.
  void step(int sense);
  /// Lets so many seconds of the wall's clock pass.
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
  /// Time was to leave the range, at its end or its beginning.
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

}  // namespace geargraph::inline view3d
