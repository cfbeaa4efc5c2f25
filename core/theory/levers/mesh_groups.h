#pragma once

#include <string>
#include <vector>

#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Meshes that are joined by links off the main axis: a gear set. What it asks of the links on the main axis
/// is asked by its meshes together.
struct MeshGroup {
  /// A wheel of the set on the main axis.
  struct Wheel {
    LinkOrdinal link = 0;
    int teeth = 1;
    friend bool operator==(const Wheel&, const Wheel&) = default;
  };
  std::vector<MeshOrdinal> meshes;  ///< ascending
  std::vector<LinkOrdinal> links;   ///< on the main axis, carriers too, ascending
  std::vector<Wheel> wheels;        ///< each once, those with fewer teeth first

  /// "48 : 96": the teeth of the wheels on the main axis.
  [[nodiscard]] std::string teethText() const;
};

/// In the order of their first meshes. Cost: near linear in n + c.
/// @pre every mesh has a geometry
[[nodiscard]] std::vector<MeshGroup> meshGroups(const Placement& placement, AxisGroupOrdinal mainAxis);

/// Is the link on the axis: the root link of the class, or a link whose joint towards the ground is in it?
[[nodiscard]] bool isOnAxis(const Placement& placement, AxisGroupOrdinal axis, LinkOrdinal link);

}  // namespace geargraph
