#pragma once

#include <optional>

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The single variable along which the losses of all meshes grow.
enum class LockingScale {
  sameEfficiency,  ///< one efficiency for all meshes, from 1 down to 0.01: they state the same one, or none
  statedLosses     ///< a factor of the stated losses 1 - eta_c: the meshes state different efficiencies
};

/// The two values between which self-locking begins: efficiencies, `moves` the greater one; or factors of the
/// stated losses, `moves` the smaller one.
struct LockingBracket {
  double moves = 0;      ///< a pattern of drivers is accepted: the train moves
  double locks = 0;      ///< no pattern is accepted: the train is self-locking
  bool isProven = true;  ///< all patterns were tried at `locks`; else only those that the iteration visits
};

/// Where the train first becomes self-locking as its losses grow; std::nullopt: at no value tried.
struct LockingLimits {
  LockingScale scale = LockingScale::sameEfficiency;
  double leastEfficiency = 1;              ///< the least one tried, of the mesh with the greatest loss
  std::optional<LockingBracket> forward;   ///< no torque of the balances moves the loads
  std::optional<LockingBracket> backward;  ///< all known torques reversed: the loads do not drive the train
};

/// Is lockingLimits() defined? It is if loads act, a motion is known, the loads are held, and every torque
/// has a value: there are no self-stresses, or stiffness decides them.
[[nodiscard]] bool hasLockingLimits(const StaticsReport& report);

/// The brackets, narrower than 1e-6 of the efficiency of the mesh with the greatest loss. First, 17 values
/// over the whole range are tried: a train that is self-locking only between two of them is missed. Each
/// value is solved in fractions. If the iteration of solveWithLosses() converges, its pattern proves that the
/// train moves. Else all patterns are tried: with more than `mostCheap` lossy meshes only at the locking end
/// of the bracket, with more than kMaxPatternMeshes nowhere, and the bracket is not proven. std::nullopt if
/// `stop` was requested.
/// Cost: some 80 values of two or three exact eliminations; at the locking end of the bracket one for each of
/// the 2^m patterns of m lossy meshes.
/// @pre hasLockingLimits(report); all of one mechanism, `options` are those of the report
[[nodiscard]] std::optional<LockingLimits> lockingLimits(const Mechanism& mechanism,
                                                         const KinematicModel& model,
                                                         const Placement& placement,
                                                         const StaticsReport& report,
                                                         const StaticsOptions& options,
                                                         const std::stop_token& stop = {}, int mostCheap = 8);

}  // namespace geargraph
