#pragma once

#include "core/teaching/force_tables/force_table.h"

namespace geargraph {

/// One torque of a cutset equation, N m: of an element that crosses the cutset, positive along the joint's
/// torque.
struct CutsetTerm {
  ElementId element;   ///< the joint itself, a mesh, a coupling; a link for a balance on it; empty for loads
  std::string symbol;  ///< "T6", "M9", "A", "l"
  Real torque;
  bool isDetermined = true;
};

/// The f-cutset of a turning joint as an equation of torques about its axis: the joint's own torque, those of
/// the meshes, couplings and balances across it, and the loads on the links beyond. The terms sum to 0.
struct CutsetWords {
  ElementId joint;
  std::vector<ElementId> beyond;  ///< the links on the far side of the joint, seen from the ground
  std::vector<CutsetTerm> terms;  ///< the joint's own first; those of meshes even if 0
  std::string sentence;           ///< "Joint 6 cuts off link 2: meshes 9 and 10 cross."
  std::string equation;           ///< "T6 + M9 + M10 = 0: -35 + 10 + 25 = 0 N m"

  /// The elements to highlight: the links beyond and the elements that cross.
  [[nodiscard]] std::vector<ElementId> elements() const;
};

/// std::nullopt without an equilibrium. Cost: O(n + c).
/// @pre all of one mechanism; `joint` is one of its turning joints
[[nodiscard]] std::optional<CutsetWords> cutsetWords(const Mechanism& mechanism, const KinematicModel& model,
                                                     const Placement& placement, const StaticsReport& report,
                                                     JointOrdinal joint);

/// Explains which gear drives, and why: "Gear 1 drives gear 4 in mesh 9: seen from carrier 2 it turns against
/// the teeth's torque on it, and they pass 490 W." std::nullopt without a motion or an equilibrium.
[[nodiscard]] std::optional<std::string> driverSentence(const Mechanism& mechanism,
                                                        const Placement& placement,
                                                        const StaticsReport& report, MeshOrdinal mesh);

}  // namespace geargraph
