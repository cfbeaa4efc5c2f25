#pragma once

#include <algorithm>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// What follows from the coefficient matrix P, with the rows of engaged couplings below it, before any choice
/// of inputs [AU, Eq. (21)].
///
/// Identity  dof = t - rank; the equations that depend on others are equations() - rank.
struct Structure {
  int rank = 0;         ///< of P (the paper says: of the cycle-basis matrix, whose rank is always c)
  int dof = 0;          ///< E: the number of inputs
  int kutzbachDof = 0;  ///< n - equations(), which is E only where no equation is redundant
  ByJoint<char> dead;   ///< it can never turn
  ByJoint<char> idle;   ///< no mesh's or coupling's cycle contains it, so it has to be an input

  /// The elimination that it was found with, modulo the first prime: free unknowns are free phi.
  Elimination<ModularDouble> system;
};

/// Rank, freedom, dead and idle joints, modulo a 61-bit prime and confirmed with a second one where rank
/// falls short of the number of meshes. std::nullopt if `stop` was requested. Cost: near linear in n + c.
[[nodiscard]] std::optional<Structure> structureOf(const KinematicModel& model,
                                                   const ModularDoubleField& field,
                                                   const std::stop_token& stop = {});

/// By joint: 1 if it is on no cycle of a mesh or an engaged coupling. Cost: O(n + c).
[[nodiscard]] std::vector<char> idleJoints(const KinematicModel& model);

/// Links that turn as one in every motion: components of at least two links connected by dead joints, the
/// links ascending.
[[nodiscard]] std::vector<std::vector<int>> rigidBlocks(const KinematicModel& model,
                                                        const std::vector<char>& dead);

/// The first `count` equations over the phi, in a field's numbers: c() are those of the meshes, equations()
/// those of the engaged couplings too.
template <class Field>
[[nodiscard]] SparseRows<typename Field::Value> equationRows(const KinematicModel& model, const Field& field,
                                                             int count) {
  SparseRows<typename Field::Value> rows;
  rows.reserve(static_cast<std::size_t>(count), 3 * static_cast<std::size_t>(count));
  const int meshes = std::min(model.c(), count);
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
    model.addMeshRow(rows, mesh, field);
    rows.endRow();
  }
  for (int equation = meshes; equation < count; ++equation) {
    KinematicModel::addHeldRow(rows, model.heldRow(equation), field);
    rows.endRow();
  }
  return rows;
}

}  // namespace geargraph
