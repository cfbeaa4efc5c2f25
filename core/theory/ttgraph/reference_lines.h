#pragma once

#include "core/mechanism/placement/placement.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {

/// What the T-T graph method reads of the drawn pose, to find which joints are coaxial and which way two
/// meshing gears turn: only where axes and pitch points are. It finds levels, carriers and signs by itself.
class ReferenceLines {
 public:
  ReferenceLines() = default;  ///< nothing is placed
  /// The completed geometry of the document, which outlives this.
  explicit ReferenceLines(const Placement& placement) : m_placement(&placement) {}

  /// By position in Mechanism::axes; null where nothing is placed.
  [[nodiscard]] const AxisLine* axis(int position) const {
    return m_placement == nullptr ? nullptr : &m_placement->axes[position];
  }
  /// All of them, by position; none if nothing is placed.
  [[nodiscard]] SpanByAxis<const AxisLine> axes() const {
    if (m_placement == nullptr) return {};
    return m_placement->axes;
  }
  /// Where the parts of a mesh are, relative to the point of the tail's line.
  struct MeshPlaces {
    Vector3 headPoint{};  ///< the point of the head's line
    Vector3 pitchPoint{};
    std::pair<double, double> helices;  ///< of the tail's and the head's gear, rad
  };
  /// By position in Mechanism::gearMeshes; std::nullopt if the mesh is not placed.
  [[nodiscard]] std::optional<MeshPlaces> placesOf(int position) const {
    if (m_placement == nullptr) return std::nullopt;
    const auto& mesh = m_placement->meshes[position];
    if (!mesh) return std::nullopt;
    return MeshPlaces{mesh->tailToHead, mesh->tailToPitch, {mesh->tailHelix, mesh->headHelix}};
  }

 private:
  const Placement* m_placement = nullptr;
};

}  // namespace geargraph
