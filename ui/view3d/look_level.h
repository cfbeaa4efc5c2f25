#pragma once

namespace geargraph::inline view3d {

/// How simple the quick looks of a picture are that moves where the processor paints: 0 as fine as they can
/// be, 1 without edges and simply lit, 2 with half the pixels too. What shows the pixels is the last that is
/// given up: most of the time goes into triangles and lines.
///
/// One slow picture does not make the next ones simpler, and it takes several quick ones until they are finer
/// again, so that the look does not flicker.
class LookLevel {
 public:
  static constexpr int kSimplest = 2;

  [[nodiscard]] int level() const { return m_level; }
  /// A quick look of this level took so many ms. `isStep`: its solids were new. Before it they were worked
  /// out, so that less time is left for it than while a camera or a clock moves.
  void took(double milliseconds, bool isStep) {
    // Of another level nothing was kept that the first of its pictures could have used.
    if (m_isFirst) return void(m_isFirst = false);
    const double slow = isStep && m_level == 0 ? 8 : 20;
    const double quick = isStep && m_level == 1 ? 3 : 9;  // a level makes about two times the time
    m_slowOnes = milliseconds > slow ? m_slowOnes + 1 : 0;
    m_quickOnes = milliseconds < quick ? m_quickOnes + 1 : 0;
    if (m_slowOnes >= 2 && m_level < kSimplest) return goTo(m_level + 1);
    if (m_quickOnes >= 8 && m_level > 0) goTo(m_level - 1);
  }

 private:
  void goTo(int level) {
    m_level = level;
    m_slowOnes = m_quickOnes = 0;
    m_isFirst = true;
  }

  int m_level = 0;
  int m_slowOnes = 0;
  int m_quickOnes = 0;
  bool m_isFirst = true;
};

}  // namespace geargraph::inline view3d
