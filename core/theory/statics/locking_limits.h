#pragma once

#include <optional>

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline statics {

/// Along which single number the losses of all meshes grow.
enum class LockingScale {
  sameEfficiency,  ///< one efficiency of all meshes, from 1 down to 0.01: they state the same, or none
  statedLosses     ///< what each mesh loses, 1 - eta_c, times one factor: they state different efficiencies
};

/// Between these two values self-locking begins. Both are efficiencies, `moves` the greater one; or factors
/// of the stated losses, `moves` the smaller one.
struct LockingBracket {
  double moves = 0;      ///< here a pattern of drivers counts: the train moves
  double locks = 0;      ///< here none counts
  bool isProven = true;  ///< all patterns were tried at `locks`; else only those that the iteration meets
};

/// Where the train locks itself first as its losses grow; none: at no value that was tried.
struct LockingLimits {
  LockingScale scale = LockingScale::sameEfficiency;
  double leastEfficiency = 1;              ///< that was tried, of the mesh that loses most
  std::optional<LockingBracket> forward;   ///< no torque of the balances moves the loads
  std::optional<LockingBracket> backward;  ///< all known torques reversed: the loads do not drive it back
};

/// The problem is one with a value where loads act, a motion is known, the loads are held, and every torque
/// has a value: without self-stresses, or with shares that stiffness decides.
[[nodiscard]] bool hasLockingLimits(const StaticsReport& report);

/// The brackets, narrower than 1e-6 of the efficiency of the mesh that loses most. 17 values are tried over
/// the whole range first, so that a train which locks between two of them only is missed. Each value is
/// solved in fractions. Where the iteration of solveWithLosses() settles, the train moves, proven by its
/// pattern. Where it does not, all patterns are tried, with more than `mostCheap` meshes only at the end of
/// the bracket, and of more than kMostPatternMeshes not at all: then the bracket is not proven. Nothing where
/// `stop` was requested. Cost: some 80 values of two or three exact eliminations; at the locking end of the
/// bracket one for each of the 2^m patterns of m lossy meshes. @pre hasLockingLimits(report); all of one
/// mechanism, `options` are those of the report
[[nodiscard]] std::optional<LockingLimits> lockingLimits(const Mechanism& mechanism,
                                                         const KinematicModel& model,
                                                         const Placement& placement,
                                                         const StaticsReport& report,
                                                         const StaticsOptions& options,
                                                         const std::stop_token& stop = {}, int mostCheap = 8);

}  // namespace geargraph::inline statics
