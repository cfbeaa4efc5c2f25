#pragma once

namespace geargraph {

/// The level of simplification of draft frames in software rendering: 0 full detail, 1 without edges and with
/// simple lighting, 2 also at half the resolution. Resolution is reduced last, since triangles and lines take
/// most of the time.
///
/// A single slow frame does not raise the level, and several fast ones are needed to lower it, so that the
/// picture does not flicker.
class DraftLevel {
 public:
  static constexpr int kSimplest = 2;

  [[nodiscard]] int level() const { return m_level; }
  /// Reports the time of a draft frame at this level, in ms. `isStep`: its solids were new; computing them
  /// leaves less time for the frame than a movement of the camera or the time.
  void took(double milliseconds, bool isStep) {
    // The first frame of a level is slower because nothing is cached for it.
    if (m_isFirst) return void(m_isFirst = false);
    const double slow = isStep && m_level == 0 ? 8 : 20;
    const double fast = isStep && m_level == 1 ? 3 : 9;  // one level is about a factor of 2 in time
    m_slowOnes = milliseconds > slow ? m_slowOnes + 1 : 0;
    m_fastOnes = milliseconds < fast ? m_fastOnes + 1 : 0;
    if (m_slowOnes >= 2 && m_level < kSimplest) return goTo(m_level + 1);
    if (m_fastOnes >= 8 && m_level > 0) goTo(m_level - 1);
  }

 private:
  void goTo(int level) {
    m_level = level;
    m_slowOnes = m_fastOnes = 0;
    m_isFirst = true;
  }

  int m_level = 0;
  int m_slowOnes = 0;
  int m_fastOnes = 0;
  bool m_isFirst = true;
};

}  // namespace geargraph
