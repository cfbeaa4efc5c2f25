#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "core/theory/statics/circulation.h"
#include "core/theory/statics/forces.h"
#include "core/theory/statics/shared_loads.h"
#include "core/theory/statics/statics_agreement.h"
#include "core/theory/statics/symbolic_efficiency.h"
#include "core/theory/statics/symbolic_statics.h"

namespace geargraph {

/// With more loaded joints than this StaticsReport::ttMatrix is omitted: the T-T graph solves one chain for
/// each.
constexpr std::size_t kMaxTtColumns = 60;

/// The options of a statics analysis.
struct StaticsOptions {
  /// Position of the state whose couplings are engaged, instead of those that the document engages; -1:
  /// these.
  int state = -1;
  bool documentLoads = true;            ///< false: `loads` only
  std::vector<Load> loads;              ///< beside those of the document
  std::vector<HoldingTorque> balances;  ///< instead of those of the document, where there are any
  bool losses = false;                  ///< with the efficiencies of the meshes
  std::optional<Rational> efficiency;   ///< for meshes that state none
  /// How self-stresses are decided; none: as the document states. Losses depend on the shares: where nothing
  /// is stated, meshes that lose power share by stiffness, which is reported.
  std::optional<LoadSharing> sharing;
  /// With a state: the torque on its drive about the direction of its own axis, N m. Loads where states are
  /// driven, and at its driven link, are left out; the driven link is the balance unless `balances` are
  /// given.
  std::optional<Rational> driveTorque;
  bool symbolic = true;
};

/// One load with its power.
struct LoadReport {
  Load load;
  RadicalColumns power;       ///< by link, for unit speeds
  std::optional<Real> watts;  ///< fed into the train; none without a motion
  int heldBy = -1;            ///< the held part, a balance, that holds it alone; -1: none
};

/// The torques of a mechanism, of one state or of none: by both methods, with losses where asked for.
struct StaticsReport {
  int state = -1;  ///< as in the options
  StaticsProblem problem;
  std::vector<LoadReport> loads;  ///< all that act
  std::vector<Load> leftOut;      ///< with options.driveTorque: those that it takes the place of
  std::vector<HeldPart> held;     ///< couplings and balances, as in the solutions' unknowns
  bool isSolved = false;          ///< false: a coupling of the state closes a linkage, named in `diagnostics`
  std::optional<Rational> ratio;  ///< of the state that was solved, drive over driven
  std::optional<Motion> motion;   ///< none if the speeds are not determined
  /// Of the links that turn freely beside a state's drive and driven link: a motion of theirs, by joint.
  /// Joints that turn in it have any rate; `motion` holds one of these. Empty: there are none.
  Motion idleMotion;
  StaticsSolution lossless;
  std::optional<StaticsAgreement> agreement;  ///< none if a mesh has no sign in the T-T graph
  std::optional<LossySolution> lossy;         ///< with options.losses and a motion
  std::optional<PowerSums> sums;              ///< with a motion, where the loads are held
  std::optional<LossySolution> backward;      ///< the known torques reversed; with `lossy`
  std::optional<PowerSums> backwardSums;
  std::optional<LoadSharing> sharing;  ///< that was asked for, by the options or the document
  bool isShared = false;               ///< self-stresses were decided by stiffness
  bool lacksLosses = false;            ///< losses were asked for and are not known: see isAnswered()
  std::vector<char> assumed;           ///< by unknown: holds by the assumption of isShared only; else empty
  /// By held part, with isShared and losses: as sharedRanges().
  std::vector<std::optional<SharedRange>> ranges;
  MeshPowers powers;                ///< with a motion; of the train with losses where these are solved
  std::optional<Real> latentRatio;  ///< as latentRatio()
  std::optional<PowerFlow> flow;    ///< with a motion, seen from the ground; of the same train
  std::optional<std::vector<Circulation>> circulations;  ///< as circulationsOf()
  StaticsForces forces;
  std::vector<int> balancedJoints;  ///< where all balances are in joints, of the transposed kinematics
  std::optional<TorqueMatrix> matrix;
  std::optional<TorqueMatrix>
      ttMatrix;  ///< the same by the T-T graph; of at most kMaxTtColumns loaded joints
  std::optional<SymbolicStatics> symbolic;
  std::optional<SymbolicStatics> ttSymbolic;   ///< the same by the T-T graph's cutsets, where it has ttMatrix
  std::optional<RationalFunction> efficiency;  ///< as symbolicEfficiency(); with options.symbolic
  std::optional<RationalFunction> backwardEfficiency;
  Diagnostics diagnostics;

  /// Do both methods give the same symbolic torques? std::nullopt if one of them gives none, or an entry
  /// exceeded its budget.
  [[nodiscard]] std::optional<bool> agreesInSymbols() const;
  /// Do torques, powers and forces answer what was asked? False where nothing holds the loads, and where the
  /// losses that were asked for are not known: a train that locks itself, or whose drivers are undecided.
  [[nodiscard]] bool isAnswered() const { return isSolved && lossless.isBalanced() && !lacksLosses; }
  /// The rate of a joint; std::nullopt without a motion, and for one that turns freely.
  [[nodiscard]] std::optional<Rational> rateOf(JointOrdinal joint) const {
    if (!motion || (!idleMotion.empty() && !idleMotion[joint].isZero())) return std::nullopt;
    return (*motion)[joint];
  }
  [[nodiscard]] bool isAssumed(int unknown) const {
    return !assumed.empty() && assumed[static_cast<std::size_t>(unknown)] != 0;
  }
  /// The solution that is shown: with losses where these are solved.
  [[nodiscard]] const StaticsSolution& solution() const {
    return lossy && lossy->outcome == LossySolution::Outcome::solved ? lossy->statics : lossless;
  }
  /// Its drivers and efficiencies, by mesh; empty without losses.
  [[nodiscard]] std::span<const MeshLoss> losses() const {
    if (!lossy || lossy->outcome != LossySolution::Outcome::solved) return {};
    return lossy->losses;
  }
};

/// std::nullopt if `stop` was requested.
/// Cost: two exact eliminations by the Matroid method and the T-T graph, more with losses and symbols.
/// @pre all of one mechanism without errors; the state exists, and with one the document engages nothing
[[nodiscard]] std::optional<StaticsReport> analyzeStatics(const Mechanism& mechanism,
                                                          const KinematicModel& model,
                                                          const Placement& placement, const TtGraph& ttGraph,
                                                          const MatroidAnalysis& analysis,
                                                          const StaticsOptions& options = {},
                                                          const std::stop_token& stop = {});

/// The power flow of a solved report with another link as the observer. @pre report.flow
[[nodiscard]] PowerFlow powerFlowSeenFrom(const Mechanism& mechanism, const KinematicModel& model,
                                          const Placement& placement, const StaticsReport& report,
                                          LinkOrdinal observer);

/// The values of a solution as doubles, for forcesOf().
[[nodiscard]] std::vector<double> numbersOf(const StaticsSolution& solution);

}  // namespace geargraph
