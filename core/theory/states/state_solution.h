#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/exact/rational_function.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// With more freewheels than this states are solved with all of them free, and say so.
constexpr int kMaxFreewheels = 12;

/// What a mechanism does with some couplings engaged: the rows of the meshes and of the couplings together,
/// solved in fractions. An engaged brake holds its link against the ground, w = 0; an engaged clutch makes
/// two links turn as one, w_a - w_b = 0. Both are vectors: where the axes between the two links are not
/// parallel they are several rows (relative_speed.h), of the reference pose.
///
/// Identity  dof = n - rank; 1 is what a gear of a gearbox has. With more it has a ratio if the others are
/// those of links that idle.
struct StateSolution {
  int state = 0;  ///< position in the document
  /// Couplings by position, each once, in the document's order of couplings; with the freewheels that lock.
  std::vector<int> engaged;
  struct Freewheel {
    ShiftElementOrdinal coupling = 0;
    bool isLocked = false;
  };
  /// What each freewheel of the document does while the drive turns the way the state says. Of all patterns
  /// of locked and free ones that counts in which every free one turns the way it may, w_0 <= w_1, and every
  /// locked one is pushed the way it holds: with it released, `driven` held and w_0 - w_1 = 1, the drive
  /// would turn forward (virtual work). Empty without a drive and a driven link, where none is decided.
  std::vector<Freewheel> freewheels;
  int rank = 0;  ///< of the rows of meshes and engaged couplings
  int dof = 0;

  bool driveTurns = false;      ///< false also where nothing is driven
  bool isDrivenAtRest = false;  ///< the speeds are known and `driven` is at rest: the ratio is infinite
  /// For `drive` at 1. Empty unless the drive turns, and either dof is 1 or the drive determines how `driven`
  /// turns; then joints that turn in `idleRates` have any rate, here that of one possible motion.
  ByJoint<Rational> rates;
  /// A motion of the links that turn freely while the drive stands, drawn at random; empty unless there are
  /// such links beside a motion in `rates`.
  ByJoint<Rational> idleRates;
  /// Absolute speed of `drive` over that of `driven`, about their common direction; where the directions
  /// differ, each about its own axis. None if there are no rates, or `driven` is at rest or turns about
  /// several directions at once.
  std::optional<Rational> ratio;
  /// The same in the gear ratios i_k; none also where it exceeded the budget.
  std::optional<RationalFunction> symbolicRatio;
  /// state-locked, state-free (also where no pattern of freewheels counts, or more than one), state-idle;
  /// turning-loop for a coupling that closes a linkage (then nothing is solved).
  Diagnostics diagnostics;

  [[nodiscard]] bool isSolved() const { return !rates.empty(); }
  /// Does the joint turn freely, whatever the drive does?
  [[nodiscard]] bool isIdle(JointOrdinal joint) const {
    return !idleRates.empty() && !idleRates[joint].isZero();
  }
};

/// Every state of the document, in its order. std::nullopt if `stop` was requested.
/// Cost: an exact elimination of the whole train for each state, near linear in n + c; `symbolic` another.
/// With m freewheels up to 2^m eliminations more. @pre model and placement are the mechanism's
[[nodiscard]] std::optional<std::vector<StateSolution>> solveStates(const Mechanism& mechanism,
                                                                    const KinematicModel& model,
                                                                    const Placement& placement,
                                                                    bool symbolic = true,
                                                                    const std::stop_token& stop = {});

/// The state at this position alone. std::nullopt if `stop` was requested. @pre there is such a state; as
/// solveStates()
[[nodiscard]] std::optional<StateSolution> solveState(const Mechanism& mechanism, const KinematicModel& model,
                                                      const Placement& placement, int state,
                                                      bool symbolic = true, const std::stop_token& stop = {});

/// The step from one gear to the next, ratio over ratio; none if one of them has no ratio or they turn
/// opposite ways.
[[nodiscard]] std::optional<Rational> stepBetween(const StateSolution& from, const StateSolution& to);

/// The diagnostics of all states, in the order of the states.
[[nodiscard]] Diagnostics stateDiagnostics(std::span<const StateSolution> states);

}  // namespace geargraph
