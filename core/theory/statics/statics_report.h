#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "core/theory/statics/circulation.h"
#include "core/theory/statics/forces.h"
#include "core/theory/statics/statics_agreement.h"
#include "core/theory/statics/symbolic_efficiency.h"
#include "core/theory/statics/symbolic_statics.h"

namespace geargraph::inline statics {

/// With more loaded joints than this StaticsReport::ttMatrix is omitted: the T-T graph solves one chain for
/// each.
constexpr std::size_t kMostTtColumns = 60;

/// The options of a statics analysis.
struct StaticsOptions {
  /// Position of the state whose couplings are engaged, instead of those that the document engages; -1:
  /// these.
  int state = -1;
  bool documentLoads = true;           ///< false: `loads` only
  std::vector<Load> loads;             ///< beside those of the document
  std::vector<Balance> balances;       ///< instead of those of the document, where there are any
  bool losses = false;                 ///< with the efficiencies of the meshes
  std::optional<Rational> efficiency;  ///< for meshes that state none
  bool stiffness = false;              ///< self-stresses by equal stiffness of all teeth
  bool symbolic = true;
};

/// One load with its power.
struct LoadReport {
  Load load;
  RadicalColumns power;       ///< by link, for unit speeds
  std::optional<Real> watts;  ///< fed into the train; none without a motion
};

/// The torques of a mechanism, of one state or of none: by both methods, with losses where asked for.
struct StaticsReport {
  StaticsProblem problem;
  std::vector<LoadReport> loads;  ///< all that act
  std::vector<HeldPart> held;     ///< couplings and balances, as in the solutions' unknowns
  bool isSolved = false;          ///< false: a coupling of the state closes a linkage, named in `diagnostics`
  std::optional<Rational> ratio;  ///< of the state that was solved, drive over driven
  std::optional<Motion> motion;   ///< none if the speeds are not determined
  StaticsSolution lossless;
  std::optional<StaticsAgreement> agreement;  ///< none if a mesh has no sign in the T-T graph
  std::optional<LossySolution> lossy;         ///< with options.losses and a motion
  std::optional<PowerSums> sums;              ///< with a motion, where the loads are held
  std::optional<LossySolution> backward;      ///< the known torques reversed; with `lossy`
  std::optional<PowerSums> backwardSums;
  bool isShared = false;            ///< self-stresses were decided by stiffness
  MeshPowers powers;                ///< with a motion; of the train with losses where these are solved
  std::optional<Real> latentRatio;  ///< as latentRatio()
  std::optional<PowerFlow> flow;    ///< with a motion, seen from the ground; of the same train
  std::optional<std::vector<Circulation>> circulations;  ///< as circulationsOf()
  StaticsForces forces;
  std::vector<int> balancedJoints;  ///< where all balances are in joints, of the transposed kinematics
  std::optional<TorqueMatrix> matrix;
  std::optional<TorqueMatrix>
      ttMatrix;  ///< the same by the T-T graph; of at most kMostTtColumns loaded joints
  std::optional<SymbolicStatics> symbolic;
  std::optional<SymbolicStatics> ttSymbolic;   ///< the same by the T-T graph's cutsets, where it has ttMatrix
  std::optional<RationalFunction> efficiency;  ///< as symbolicEfficiency(); with options.symbolic
  std::optional<RationalFunction> backwardEfficiency;
  Diagnostics diagnostics;

  /// Do both methods give the same symbolic torques? std::nullopt if one of them gives none, or an entry
  /// exceeded its budget.
  [[nodiscard]] std::optional<bool> agreesInSymbols() const;
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

}  // namespace geargraph::inline statics
