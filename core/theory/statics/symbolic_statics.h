#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/expansion.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/statics/cutset_equations.h"

namespace geargraph {

/// The transposed kinematics in the gear ratios i_k = N_tail / N_head: torques in the balanced joints that
/// hold the loads in the other joints, by the cutset equations (19*) with normalised columns of P:
///
///     tau_e = sum over meshes c of +-(i_c or 1) f_c,      f_c = F_c |P_c,head|  (N m)
///
/// f_c is the torque of mesh c on the head's gear about its axis, up to the sign s. (25*) for the paper's
/// robot.
struct SymbolicStatics {
  /// A term of a line: the torque of an earlier line, or of a loaded joint.
  struct Term {
    MeshOrdinal mesh = -1;    ///< f of this mesh; -1: tau of `joint`
    JointOrdinal joint = -1;  ///< a loaded joint
    RationalFunction coefficient;
  };
  /// One line of the substitution: an unknown over the joints' loads and the unknowns of earlier lines.
  struct Line {
    MeshOrdinal mesh = -1;    ///< f of this mesh; -1: tau of `joint`
    JointOrdinal joint = -1;  ///< a balanced joint
    int cutset = -1;          ///< the joint whose cutset gives it; -1 where elimination combined several
    std::vector<Term> terms;
  };
  RatioRingPtr ring;          ///< variable m is the ratio of mesh m, "i15"
  std::vector<int> balanced;  ///< joints
  std::vector<int> loaded;    ///< joints
  std::vector<Line> lines;
  /// tau_balanced = matrix * tau_loaded, row by row; none for an entry that exceeded the budget.
  std::vector<std::optional<RationalFunction>> matrix;
  int skipped = 0;  ///< entries over the budget
};

/// std::nullopt if `stop` was requested, the coupled core of the equations exceeded its budget, or the
/// balances do not determine the meshes. `meshes`: independent ones, r of them. `loaded`: the joints that
/// bear loads, none of them balanced. Cost: as solveSymbolic().
[[nodiscard]] std::optional<SymbolicStatics> solveStaticsSymbolic(
    const Mechanism& mechanism, const CutsetEquations& cutsets, std::span<const int> meshes,
    std::span<const int> balanced, std::span<const int> loaded, const std::stop_token& stop = {},
    ExpansionBudget budget = {});

}  // namespace geargraph
