#pragma once

#include "core/placement/placement.h"
#include "core/placement/tolerance.h"

namespace geargraph {

/// Where the T-T graph method looks when it needs the drawn pose: to tell which joints are coaxial and which
/// way two meshing gears turn. Of a placement it takes where things are, and no more: it finds levels,
/// carriers and signs by itself.
class ReferenceLines {
 public:
  ReferenceLines() = default;  ///< nothing is placed
  /// The completed geometry of the document. Refers to it.
  explicit ReferenceLines(const Placement& placement) : m_placement(&placement) {}

  /// By position in Mechanism::axes; null where nothing says it.
  [[nodiscard]] const AxisLine* axis(int position) const {
    return m_placement == nullptr ? nullptr : &m_placement->axes[static_cast<std::size_t>(position)];
  }
  /// By position in Mechanism::gearMeshes, likewise.
  [[nodiscard]] const Vector3* pitchPoint(int position) const {
    if (m_placement == nullptr) return nullptr;
    const auto& mesh = m_placement->meshes[static_cast<std::size_t>(position)];
    return mesh ? &mesh->pitchPoint : nullptr;
  }

 private:
  const Placement* m_placement = nullptr;
};

/// The same direction or the opposite one, as far as decimals tell.
[[nodiscard]] inline bool areParallel(const AxisLine& a, const AxisLine& b) {
  const Vector3 normal = cross(a.direction, b.direction);
  return dot(normal, normal) <= kSameLine * kSameLine;
}
/// The same line in space, whichever way it points, as far as decimals tell.
[[nodiscard]] bool areCollinear(const AxisLine& a, const AxisLine& b);

}  // namespace geargraph
