#include "ui/view3d/playback.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr int kMillisecondsPerFrame = 16;
constexpr double kStep = 0.05;  // s
constexpr double kMaxFrame =
    0.25;  // s: after a pause of the whole program the motion goes on, it does not jump

}  // namespace

Playback::Playback(QObject* parent) : QObject(parent) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(kMillisecondsPerFrame);
  connect(&m_timer, &QTimer::timeout, this, [this] {
    advance(std::min(kMaxFrame, static_cast<double>(m_sinceFrame.nsecsElapsed()) * 1e-9));
    m_sinceFrame.restart();
  });
}

void Playback::setPeriod(double seconds) {
  m_period = std::isfinite(seconds) && seconds > 0 ? seconds : 0;
  setTime(m_time);
}

bool Playback::isLimited() const {
  return std::isfinite(m_from) || std::isfinite(m_to);
}

void Playback::setRange(double from, double to) {
  if (!(from <= to)) return;
  const bool same = from == m_from && to == m_to;
  m_from = from;
  m_to = to;
  setTime(m_time);
  if (!same) emit rangeChanged();
}

void Playback::advance(double seconds) {
  const double next = m_time + m_speed * seconds;
  const bool isOut = next > m_to || next < m_from;
  setTime(next);
  if (!isOut) return;
  emit endReached(next > m_to);
  setSpeed(-m_speed);
}

void Playback::step(int sense) {
  setPlaying(false);
  const double next = m_time + sense * kStep * std::abs(m_speed);
  setTime(next);
  if (next > m_to || next < m_from) emit endReached(next > m_to);
}

void Playback::setPlaying(bool playing) {
  if (playing == isPlaying()) return;
  if (playing) {
    m_sinceFrame.start();
    m_timer.start();
  } else {
    m_timer.stop();
  }
  emit playingChanged(playing);
}

void Playback::setTime(double seconds) {
  if (!std::isfinite(seconds)) return;
  if (isLimited()) {
    seconds = std::clamp(seconds, m_from, m_to);
  } else if (m_period > 0 && (seconds < 0 || seconds > m_period)) {
    seconds -= m_period * std::floor(seconds / m_period);
  }
  if (seconds == m_time) return;
  m_time = seconds;
  emit timeChanged(m_time);
}

void Playback::setSpeed(double speed) {
  if (speed == m_speed || !std::isfinite(speed)) return;
  m_speed = speed;
  emit speedChanged(speed);
}

}  // namespace geargraph

#include "moc_playback.cpp"
