#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/exact/radical_columns.h"
#include "core/theory/ttgraph/substitution.h"

namespace geargraph {

// Statics by the T-T graph's own terminal equations and cutsets, without the coefficient matrix.
//
// The terminal equation (26) w_ik = s n_ji w_jk has the dual (26*) M_jk = -s n_ji M_ik: the port's power
// M_ik w_ik + M_jk w_jk is 0. M_ik is the torque by the mesh on the tail's gear i about its axis, seen from
// the carrier k, M_jk that on the head's gear j; the carrier has the reactions.
//
// One f-cutset per tree branch e, with the coefficients of the f-circuits of its chords (31)-(38):
//
//     M_e + sum over the chords through the cutset of B(chord, e) M_chord + ell_e = 0,
//
// M_e the torque in joint e, by its tail on its head, about +direction of its axis; ell_e the power of loads
// on links beyond e for the joint's rate 1. Torques that hold links together (couplings, balances) are
// further chords. The chain runs from the loads back to the motors, the reverse of (39)-(42): take a cutset
// with one unknown left, then the terminal equation of its mesh, and repeat; coupled unknowns are solved
// together.

/// A further chord: the coefficient of each branch in its f-circuit, (joint, coefficient).
using TtChord = std::vector<std::pair<int, Rational>>;

/// One step of the chain.
struct TtStaticStep {
  MeshOrdinal mesh = -1;    ///< the unknown: the port torques of this mesh; -1: the torque of `chord`
  int chord = -1;           ///< a further chord
  JointOrdinal joint = -1;  ///< the branch whose cutset gives it; -1 where several are solved together
  bool coupled = false;     ///< with others
};

/// Port torques and torques of further chords, in N m.
struct TtTorques {
  bool isBalanced = true;  ///< false: the loads are not held, the values are meaningless
  ByMesh<Real> tailPorts;  ///< M_ik, 0 for what is free in self-stresses
  ByMesh<Real> headPorts;  ///< M_jk
  std::vector<Real> chords;
  ByMesh<char> meshDetermined;
  std::vector<char> chordDetermined;  ///< by chord
  std::vector<TtStaticStep> steps;    ///< empty where the equations are taken by levels
};

/// `loads`: by branch e, the loads tau_e + ell_e. Exact. std::nullopt if `stop` was requested. Where the
/// circuits have more than `mostTerms` terms, cutsets along a level are subtracted from each other, which
/// leaves one balance per link.
/// Cost: the circuit terms, or O(n + c); one elimination.
/// @pre graph.isComplete()
[[nodiscard]] std::optional<TtTorques> ttTorques(const TtGraph& graph, std::span<const TtChord> chords,
                                                 const RadicalColumns& loads,
                                                 const std::stop_token& stop = {},
                                                 long long mostTerms = kMaxCircuitTerms);

}  // namespace geargraph
