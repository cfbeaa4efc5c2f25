#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline force_tables {

/// A row of P beside one of its columns: the speeds of a mesh (17) and the torque in a joint (17*) have one
/// entry in common. Lengths are counted in teeth, so that all entries are whole numbers.
struct TwinWords {
  int mesh = 0;
  int joint = 0;
  std::vector<int> joints;              ///< positions, ascending: those of the row, and `joint`
  std::vector<int> meshes;              ///< positions, ascending: those of the column, and `mesh`
  std::vector<std::vector<int>> cells;  ///< P by mesh and joint, in teeth
  std::string speeds;                   ///< "60·28.5714 - 60·0 - 18·95.2381 = 0"; empty without a motion
  std::string torque;  ///< what the meshes hold in the joint, N m; empty where it is not determined
};

/// Where only one of both is chosen, the other is the first that has an entry with it; with neither, the
/// first mesh. None without meshes, or where the chosen one has no entry at all. Cost: the entries of P.
/// @pre all of one mechanism without errors; the positions exist
[[nodiscard]] std::optional<TwinWords> twinWords(const Mechanism& mechanism, const KinematicModel& model,
                                                 const Placement& placement, const StaticsReport& report,
                                                 std::optional<int> joint, std::optional<int> mesh);

}  // namespace geargraph::inline force_tables
