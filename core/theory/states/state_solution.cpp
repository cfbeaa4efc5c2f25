#include "core/theory/states/state_solution.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/exact/expansion.h"
#include "core/mechanism/model/slide_checks.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/state_diagnostics.h"
#include "core/theory/states/state_system.h"

namespace geargraph {
namespace {

/// Solves the states of one mechanism, one after the other.
class StateSolver {
 public:
  StateSolver(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
              RatioRingPtr ring, const std::stop_token& stop)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_ring(std::move(ring)),
        m_stop(stop),
        m_linkAt(mechanism.links),
        m_couplingAt(mechanism.couplings) {}

  /// Nothing where `stop` was requested.
  std::optional<StateSolution> solve(int position) {
    const ShiftState& state = m_mechanism.states[static_cast<std::size_t>(position)];
    StateSolution result;
    result.state = position;
    for (const ShiftElementId id : state.engaged) result.engaged.push_back(m_couplingAt.at(id));
    std::sort(result.engaged.begin(), result.engaged.end());
    result.engaged.erase(std::unique(result.engaged.begin(), result.engaged.end()), result.engaged.end());
    if (m_model.hasPi()) {
      result.diagnostics.push_back(slidesNotCovered(m_mechanism, translated("Ratios of states with pi")));
      return result;
    }
    const std::vector<int> freewheels = freewheelsOf();
    if (freewheels.empty() || !state.drive || !state.driven) return solvedAsEngaged(std::move(result));
    return solvedByPatterns(state, std::move(result), freewheels);
  }

 private:
  [[nodiscard]] std::vector<int> freewheelsOf() const {
    std::vector<int> found;
    for (ShiftElementOrdinal coupling = 0; coupling < static_cast<int>(m_mechanism.couplings.size());
         ++coupling) {
      if (m_mechanism.couplings[coupling].kind == ShiftElementKind::freewheel) found.push_back(coupling);
    }
    return found;
  }

  /// How much faster the first link of a freewheel turns than the second (freewheelSense()); none where that
  /// has no sense.
  [[nodiscard]] std::optional<RelativeSpeed::Part> slipOf(ShiftElementOrdinal coupling) const {
    const int sense = freewheelSense(m_mechanism, m_placement, coupling);
    if (sense == 0) return std::nullopt;
    const KinematicModel::HeldRow row = heldRows(m_mechanism, m_placement, coupling).front();
    RelativeSpeed::Part slip{row.axisGroup, {}};
    for (const KinematicModel::HeldRow::Term& term : row.links)
      slip.terms.push_back({term.of, sense * term.factor});
    return slip;
  }

  [[nodiscard]] static Rational speedOf(const RelativeSpeed::Part& part, const std::vector<Rational>& phi) {
    return valueOf(RationalField(), part, phi);
  }

  enum class Push { forward, none, backward };
  /// Which way the drive would turn if the freewheel slipped against its locking with `driven` held; `none`
  /// also where that is not determined.
  [[nodiscard]] Push pushOn(const ShiftState& state, std::vector<int> engaged, ShiftElementOrdinal freewheel,
                            const RelativeSpeed::Part& slip) const {
    std::erase(engaged, freewheel);
    StateSystem system = systemOf(state, engaged);
    if (!system.drive) return Push::none;
    const RelativeSpeed::Part drive = *std::move(system.drive);
    system.drive = slip;
    for (const RelativeSpeed::Part& part :
         RelativeSpeed::between(m_placement, 0, m_linkAt.at(*state.driven)).parts) {
      KinematicModel::HeldRow& row = system.held.emplace_back();
      for (const RelativeSpeed::Term& term : part.terms) row.links.push_back({term.link, term.factor});
    }
    const auto solved = eliminated(system, m_model, m_stop);
    std::vector<Rational> phi;
    if (!solved || !driveIsFree(*solved, phi)) return Push::none;
    if (!solved->freeColumns.empty() && !speedOf(drive, freeMotion(*solved)).isZero()) return Push::none;
    const int sign = speedOf(drive, phi).sign() * senseOf(state);
    return sign > 0 ? Push::forward : sign < 0 ? Push::backward : Push::none;
  }
  [[nodiscard]] static int senseOf(const ShiftState& state) {
    return state.direction && state.direction->exact().sign() < 0 ? -1 : 1;
  }

  /// The state with each pattern of locked freewheels; the first that counts. Where none does, that of what
  /// would have to lock, or all free.
  std::optional<StateSolution> solvedByPatterns(const ShiftState& state, const StateSolution& start,
                                                const std::vector<int>& freewheels) {
    std::vector<std::optional<RelativeSpeed::Part>> slips;
    for (const ShiftElementOrdinal each : freewheels) slips.push_back(slipOf(each));
    const bool isDecided =
        static_cast<int>(freewheels.size()) <= kMaxFreewheels &&
        std::all_of(slips.begin(), slips.end(), [](const auto& slip) { return slip.has_value(); });
    std::optional<StateSolution> found;   // the first that counts,
    std::optional<StateSolution> weak;    // where a locked one bears nothing,
    std::optional<StateSolution> forced;  // where none counts: the pattern that the free ones ask for
    std::uint32_t asked = 0;
    int counting = 0;
    const std::uint32_t patterns = isDecided ? 1U << freewheels.size() : 1;
    for (std::uint32_t pattern = 0; pattern < patterns; ++pattern) {
      StateSolution next = start;
      for (std::size_t k = 0; k < freewheels.size(); ++k) {
        const bool isLocked = (pattern >> k & 1U) != 0;
        next.freewheels.push_back({freewheels[k], isLocked});
        if (isLocked) next.engaged.push_back(freewheels[k]);
      }
      std::sort(next.engaged.begin(), next.engaged.end());
      m_phi.clear();
      auto tried = solvedAsEngaged(std::move(next));
      if (!tried) return std::nullopt;
      std::uint32_t overrun = 0;  // free ones that turn the way they may not
      bool isPushed = true, isPushedHard = true;
      if (tried->isSolved()) {
        for (std::size_t k = 0; isDecided && k < freewheels.size(); ++k) {
          if ((pattern >> k & 1U) == 0) {
            if (speedOf(*slips[k], m_phi).sign() * senseOf(state) > 0) overrun |= 1U << k;
            continue;
          }
          const Push push = pushOn(state, tried->engaged, freewheels[k], *slips[k]);
          isPushed = isPushed && push != Push::backward;
          isPushedHard = isPushedHard && push == Push::forward;
        }
      }
      const bool counts = tried->isSolved() && overrun == 0;
      if (counts && isPushedHard) {
        if (++counting == 1) found = tried;
      } else if (counts && isPushed && !weak) {
        weak = tried;
      }
      if (pattern == asked) {
        forced = std::move(tried);
        if ((asked | overrun) != asked) asked |= overrun;  // comes later: it is a larger number
      }
    }
    if (counting > 1) found->diagnostics.push_back(freewheelsOpen(m_mechanism, state, found->freewheels));
    if (found) return found;
    if (weak) return weak;
    if (forced && !isDecided) forced->freewheels.clear();
    if (forced && forced->isSolved())  // its freewheels are locked against their push: the drive overruns
      forced->diagnostics.push_back(freewheelsOverrun(m_mechanism, state, forced->freewheels));
    return forced;
  }

  /// With the couplings that the result names. Nothing where `stop` was requested.
  std::optional<StateSolution> solvedAsEngaged(StateSolution result) {
    const ShiftState& state = m_mechanism.states[static_cast<std::size_t>(result.state)];
    result.diagnostics = engagementOf(m_mechanism, m_placement, result.engaged, &state).diagnostics;
    if (!result.diagnostics.empty()) return result;

    const StateSystem system = systemOf(state, result.engaged);
    const auto solution = eliminated(system, m_model, m_stop);
    if (!solution) return std::nullopt;
    std::vector<Rational>& phi = m_phi;
    result.driveTurns = driveIsFree(*solution, phi);
    result.rank = solution->rank() - (result.driveTurns ? 1 : 0);
    result.dof = m_model.n() - result.rank;
    if (state.drive && !result.driveTurns) result.diagnostics.push_back(locked(state, result.engaged));
    bool isDetermined = result.dof == 1;
    if (result.dof > 1) {
      const std::vector<Rational> idle = freeMotion(*solution);
      isDetermined = result.driveTurns && state.driven && !turns(m_linkAt.at(*state.driven), idle);
      const std::vector<int> links = turningLinks(idle);
      result.diagnostics.push_back(isDetermined ? stateIdle(m_mechanism, state, links)
                                                : stateFree(m_mechanism, state, result.dof, links));
      if (isDetermined) result.idleRates = ratesOf(idle);
    }
    if (isDetermined && result.driveTurns) fillSpeeds(state, system, *solution, phi, result);
    if (m_stop.stop_requested()) return std::nullopt;
    return result;
  }

  [[nodiscard]] int ownClass(LinkOrdinal link) const { return m_placement.classes->classOfLink(link); }
  /// +1 where the axis of the link's own joint points as the line of the class does.
  [[nodiscard]] int ownOrientationSign(LinkOrdinal link) const {
    return m_placement.classes->orientationSign[m_placement.tree->joint[link]];
  }

  [[nodiscard]] StateSystem systemOf(const ShiftState& state, const std::vector<int>& engaged) const {
    StateSystem system;
    system.held = engagementOf(m_mechanism, m_placement, engaged).rows;
    if (!state.drive) return system;
    const int drive = m_linkAt.at(*state.drive);
    system.drive = RelativeSpeed::Part{};  // the ground: no term, so that it cannot turn
    for (RelativeSpeed::Part& part : RelativeSpeed::between(m_placement, 0, drive).parts) {
      const int sign =
          directionSign(m_placement, part.axisGroup, ownClass(drive)) * ownOrientationSign(drive);
      if (sign == 0) continue;
      for (RelativeSpeed::Term& term : part.terms) term.factor *= sign;
      system.drive = std::move(part);
    }
    return system;
  }

  [[nodiscard]] bool driveTurnsWith(const ShiftState& state, const std::vector<int>& engaged) const {
    const auto system = eliminated(systemOf(state, engaged), m_model, m_stop);
    std::vector<Rational> phi;
    return system && driveIsFree(*system, phi);
  }

  [[nodiscard]] Diagnostic locked(const ShiftState& state, const std::vector<int>& engaged) const {
    if (!driveTurnsWith(state, {})) return stateLocked(m_mechanism, state, {}, true);
    std::vector<int> locking;
    for (const ShiftElementOrdinal coupling : engaged) {
      std::vector<int> others = engaged;
      std::erase(others, coupling);
      if (driveTurnsWith(state, others)) locking.push_back(coupling);
    }
    return stateLocked(m_mechanism, state, locking, false);
  }

  /// The phi of a motion drawn at random while the drive stands.
  [[nodiscard]] static std::vector<Rational> freeMotion(const Elimination<Rational>& system) {
    const RationalField field;
    const PrimeField prime;
    ResidueStream random(prime, 0x66726565U);
    std::vector<Rational> phi(static_cast<std::size_t>(system.columns), Rational(0));
    for (const int column : system.freeColumns)
      phi[static_cast<std::size_t>(column)] =
          static_cast<std::int64_t>(prime.toNumber(random.next()) >> 30U) + 1;
    substitute(field, system, phi);
    return phi;
  }

  [[nodiscard]] bool turns(LinkOrdinal link, const std::vector<Rational>& phi) const {
    const RationalField field;
    const RelativeSpeed speed = RelativeSpeed::between(m_placement, 0, link);
    return std::any_of(speed.parts.begin(), speed.parts.end(),
                       [&](const RelativeSpeed::Part& part) { return !valueOf(field, part, phi).isZero(); });
  }

  [[nodiscard]] std::vector<int> turningLinks(const std::vector<Rational>& phi) const {
    std::vector<int> links;
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link)
      if (turns(link, phi)) links.push_back(link);
    return links;
  }

  [[nodiscard]] ByJoint<Rational> ratesOf(const std::vector<Rational>& phi) const {
    const RationalField field;
    ByJoint<Rational> rates;
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint)
      rates.push_back(m_model.rateOf(field, joint, phi));
    return rates;
  }

  void fillSpeeds(const ShiftState& state, const StateSystem& system, const Elimination<Rational>& solved,
                  const std::vector<Rational>& phi, StateSolution& result) const {
    const RationalField field;
    result.rates = ratesOf(phi);
    if (!state.driven) return;
    const int driven = m_linkAt.at(*state.driven);
    const RelativeSpeed::Part* turning = nullptr;
    int directions = 0;
    const RelativeSpeed speed = RelativeSpeed::between(m_placement, 0, driven);
    for (const RelativeSpeed::Part& part : speed.parts) {
      if (valueOf(field, part, phi).isZero()) continue;
      turning = &part;
      ++directions;
    }
    result.isDrivenAtRest = directions == 0;
    if (directions != 1) return;
    const int sign = senseOfDriven(m_linkAt.at(*state.drive), driven, turning->axisGroup);
    result.ratio = (Rational(sign) * valueOf(field, *turning, phi)).inverse();
    if (!std::isfinite(result.ratio->toDouble())) {
      result.ratio.reset();
      result.diagnostics.push_back(ratioBeyondRange(state));
      return;
    }
    if (m_ring) result.symbolicRatio = symbolicRatio(system, solved, *turning, sign);
  }

  /// +1 where the class's line points as the drive's axis does; where that lies across, as driven's own axis.
  [[nodiscard]] int senseOfDriven(int drive, int driven, AxisGroupOrdinal axisGroup) const {
    const int along = directionSign(m_placement, axisGroup, ownClass(drive)) * ownOrientationSign(drive);
    if (along != 0) return along;
    const int own = directionSign(m_placement, axisGroup, ownClass(driven)) * ownOrientationSign(driven);
    return own == 0 ? 1 : own;
  }

  /// The equations of independent rows in the ratios i_k: true for these teeth, and for all others that leave
  /// the state its freedom.
  [[nodiscard]] std::optional<RationalFunction> symbolicRatio(const StateSystem& system,
                                                              const Elimination<Rational>& solved,
                                                              const RelativeSpeed::Part& driven,
                                                              int sign) const {
    constexpr int kMaxTermsOfTheCore = 600;
    std::vector<char> left(static_cast<std::size_t>(m_model.c()) + system.held.size() + 1, 0);
    for (const auto& check : solved.checks) left[static_cast<std::size_t>(check.source)] = 1;

    std::stop_source enough;
    const std::stop_callback forward(m_stop, [&] { enough.request_stop(); });
    const RationalFunctionField bounded(m_ring, kMaxTermsOfTheCore, enough);
    const RationalFunctionField field(m_ring);
    const auto ratio = [&](MeshOrdinal mesh, bool tail) {
      return tail ? RationalFunction::variable(m_ring, mesh) : field.one();
    };
    const auto symbols = eliminate(bounded, system.rows(m_model, bounded, ratio, left), m_model.n(),
                                   m_model.n() + 1, enough.get_token());
    if (!symbols) return std::nullopt;
    const auto speedOfDriven = [&](int drive, int idle) -> std::optional<RationalFunction> {
      std::vector<std::optional<RationalFunction>> phi(static_cast<std::size_t>(symbols->columns));
      phi.back() = field.fromInteger(drive);
      for (const int column : symbols->freeColumns)
        phi[static_cast<std::size_t>(column)] =
            field.fromInteger(static_cast<std::int64_t>(idle) * (column + 1));
      ExpansionBudget budget;
      if (!expand(field, *symbols, std::vector<char>(phi.size(), 0), phi, budget, m_stop))
        return std::nullopt;
      RationalFunction speed = field.fromInteger(0);
      for (const RelativeSpeed::Term& term : driven.terms) {
        const auto& value = phi[static_cast<std::size_t>(term.link) - 1];
        if (!value) return std::nullopt;
        speed += field.fromInteger(static_cast<std::int64_t>(sign) * term.factor) * *value;
      }
      return speed;
    };
    if (!symbols->freeColumns.empty()) {
      // What idles at these teeth may drive at others: then the ratio is no function of the teeth.
      const auto idle = speedOfDriven(0, 1);
      if (!idle || !idle->isZero()) return std::nullopt;
    }
    const auto speed = speedOfDriven(1, 0);
    if (!speed || speed->isZero()) return std::nullopt;
    RationalFunction result = field.one() / *speed;
    if (result.termCount() > kExpansionBudget) return std::nullopt;
    return result;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  RatioRingPtr m_ring;  ///< null: no symbols
  std::stop_token m_stop;
  PositionIndex<LinkTag> m_linkAt;
  PositionIndex<CouplingTag> m_couplingAt;
  std::vector<Rational> m_phi;  ///< of the last solvedAsEngaged() for the drive at 1
};

}  // namespace

std::optional<std::vector<StateSolution>> solveStates(const Mechanism& mechanism, const KinematicModel& model,
                                                      const Placement& placement, bool symbolic,
                                                      const std::stop_token& stop) {
  StateSolver solver(mechanism, model, placement, symbolic ? ratioRingOf(mechanism) : nullptr, stop);
  std::vector<StateSolution> solutions;
  for (int state = 0; state < static_cast<int>(mechanism.states.size()); ++state) {
    auto solution = solver.solve(state);
    if (!solution) return std::nullopt;
    solutions.push_back(std::move(*solution));
  }
  return solutions;
}

std::optional<StateSolution> solveState(const Mechanism& mechanism, const KinematicModel& model,
                                        const Placement& placement, int state, bool symbolic,
                                        const std::stop_token& stop) {
  return StateSolver(mechanism, model, placement, symbolic ? ratioRingOf(mechanism) : nullptr, stop)
      .solve(state);
}

std::optional<Rational> stepBetween(const StateSolution& from, const StateSolution& to) {
  if (!from.ratio || !to.ratio || from.ratio->sign() != to.ratio->sign()) return std::nullopt;
  return *from.ratio / *to.ratio;
}

Diagnostics stateDiagnostics(std::span<const StateSolution> states) {
  Diagnostics all;
  for (const StateSolution& state : states) append(all, state.diagnostics);
  return all;
}

}  // namespace geargraph
