#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The duality of kinematics and statics: a row of P, for the speeds of a mesh (17), and a column, for the
/// torque in a joint (17*), with their common entry. Lengths are counted in teeth, so that all entries are
/// integers.
struct DualEquations {
  MeshOrdinal mesh = 0;
  JointOrdinal joint = 0;
  std::vector<int> joints;              ///< positions, ascending: those of the row, and `joint`
  std::vector<int> meshes;              ///< positions, ascending: those of the column, and `mesh`
  std::vector<std::vector<int>> cells;  ///< P by mesh and joint, in teeth
  std::string speeds;                   ///< "60·28.5714 - 60·0 - 18·95.2381 = 0"; empty without a motion
  std::string torque;                   ///< the equation of the joint's torque, N m; empty if not determined
};

/// If only one of the two is given, the other is the first with a common entry; with neither, the first mesh
/// is taken. std::nullopt without meshes, or if the given one has no entry. Cost: the entries of P.
/// @pre all of one mechanism without errors; the positions exist
[[nodiscard]] std::optional<DualEquations> dualEquations(const Mechanism& mechanism,
                                                         const KinematicModel& model,
                                                         const Placement& placement,
                                                         const StaticsReport& report,
                                                         std::optional<int> joint, std::optional<int> mesh);

}  // namespace geargraph
