#pragma once

#include "core/mechanism/placement/placement.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph::inline ttgraph {

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
  /// All of them, by position; none where nothing is placed.
  [[nodiscard]] std::span<const AxisLine> axes() const {
    if (m_placement == nullptr) return {};
    return m_placement->axes;
  }
  /// Where things of a mesh are, by position in Mechanism::gearMeshes, seen from the point of the tail's
  /// line; none where nothing says it.
  struct MeshPlaces {
    Vector3 headPoint{};  ///< the point of the head's line
    Vector3 pitchPoint{};
  };
  [[nodiscard]] std::optional<MeshPlaces> placesOf(int position) const {
    if (m_placement == nullptr) return std::nullopt;
    const auto& mesh = m_placement->meshes[static_cast<std::size_t>(position)];
    if (!mesh) return std::nullopt;
    return MeshPlaces{mesh->tailToHead, mesh->tailToPitch};
  }

 private:
  const Placement* m_placement = nullptr;
};

}  // namespace geargraph::inline ttgraph
