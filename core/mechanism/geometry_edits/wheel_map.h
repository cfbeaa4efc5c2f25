#pragma once

#include <vector>

#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Which ends of meshes belong to one wheel: those that name the same wheel, else those with the same link,
/// axis, tooth count and plane. A change of the teeth of a wheel changes all its ends.
///
/// An end is 2 * mesh for the tail, 2 * mesh + 1 for the head.
class WheelMap {
 public:
  /// @pre every mesh has a geometry in the placement, which is the mechanism's
  WheelMap(const Mechanism& mechanism, const Placement& placement);

  [[nodiscard]] int count() const { return static_cast<int>(m_ends.size()); }
  [[nodiscard]] int wheelOf(int end) const { return m_wheelOf[static_cast<std::size_t>(end)]; }
  [[nodiscard]] const std::vector<int>& ends(int wheel) const {
    return m_ends[static_cast<std::size_t>(wheel)];
  }
  /// The identical planets of a set: wheels on other links that mesh with the same wheels in the same way on
  /// the same carrier, with as many teeth.
  [[nodiscard]] std::vector<int> identicalPlanets(int wheel) const;

 private:
  struct Neighbour {
    int wheel = 0;
    MeshKind kind = kUsualKind;
    LinkOrdinal carrier = 0;
    friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
  };
  [[nodiscard]] bool isSame(const Mechanism& mechanism, const Placement& placement, int end, int other) const;

  std::vector<int> m_wheelOf;
  std::vector<std::vector<int>> m_ends;  ///< by wheel
  std::vector<std::vector<Neighbour>> m_neighbours;
  std::vector<int> m_link;   ///< by wheel
  std::vector<int> m_teeth;  ///< by wheel
};

[[nodiscard]] inline bool isTailEnd(int end) {
  return end % 2 == 0;
}
[[nodiscard]] inline int otherEnd(int end) {
  return isTailEnd(end) ? end + 1 : end - 1;
}
[[nodiscard]] int teethOf(const Mechanism& mechanism, int end);
/// The axis class about whose line the end's gear turns.
[[nodiscard]] int classOfEnd(const Placement& placement, int end);

}  // namespace geargraph
