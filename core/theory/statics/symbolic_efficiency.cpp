#include "core/theory/statics/symbolic_efficiency.h"

#include <flint/fmpq.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "core/foundations/exact/elimination.h"
#include "core/theory/statics/statics_system.h"

namespace geargraph {
namespace {

using Function = RationalFunction;

class Solver {
 public:
  Solver(const Mechanism& mechanism, const KinematicModel& model, const EfficiencyProblem& problem,
         const LossySolution& solution, const Motion& motion, std::int64_t mostTerms,
         const std::stop_token& stop)
      : m_model(model),
        m_problem(problem),
        m_solution(solution),
        m_motion(motion),
        m_forward(stop, [this] { m_enough.request_stop(); }),
        m_etaOf(static_cast<std::size_t>(model.c()), -1),
        m_ring(ringOf(mechanism)),
        m_mostTerms(mostTerms),
        m_field(m_ring, kTermsOnTheWay * mostTerms, m_enough) {}

  std::optional<Function> run() {
    for (const RadicalColumns& load : m_problem.loads)
      for (const auto& [link, factor] : load.columns().front().entries) m_loads.add(link, factor);
    if (!isRational()) return std::nullopt;
    const auto phi = speeds();
    if (!phi) return std::nullopt;
    const auto torques = unknownTorques();
    if (!torques) return std::nullopt;
    Function fed = m_field.fromInteger(0);
    Function taken = m_field.fromInteger(0);
    const auto add = [&](int sign, const Function& power) {
      if (sign > 0) fed += power;
      if (sign < 0) taken -= power;
    };
    for (const RadicalColumns& load : m_problem.loads) {
      const int sign = powerOf(m_model, load, m_motion).sign();
      Function power = m_field.fromInteger(0);
      for (const auto& [link, factor] : load.columns().front().entries)
        power += number(factor) * (*phi)[static_cast<std::size_t>(link)];
      add(sign, power);
    }
    for (std::size_t part = 0; part < m_solution.statics.held.size(); ++part) {
      Function speed = m_field.fromInteger(0);
      for (const auto& [link, factor] : m_solution.statics.held[part].byLink)
        speed += number(factor) * (*phi)[static_cast<std::size_t>(link)];
      add(m_solution.powers.held[part].sign(),
          (*torques)[static_cast<std::size_t>(m_model.c()) + part] * speed);
    }
    if (m_enough.stop_requested() || fed.isZero()) return std::nullopt;
    Function efficiency = taken / fed;
    if (efficiency.termCount() > m_mostTerms) return std::nullopt;
    return efficiency;
  }

 private:
  /// What may be met on the way to a short result.
  static constexpr std::int64_t kTermsOnTheWay = 4;

  static bool fits(const Rational& value) {
    return fmpz_fits_si(fmpq_numref(value.flint())) != 0 && fmpz_fits_si(fmpq_denref(value.flint())) != 0;
  }
  /// @pre fits(value)
  [[nodiscard]] Function number(const Rational& value) const {
    Function result = m_field.fromInteger(fmpz_get_si(fmpq_numref(value.flint())));
    if (!value.isInteger()) result /= m_field.fromInteger(fmpz_get_si(fmpq_denref(value.flint())));
    return result;
  }

  /// The ratios of all meshes, then the efficiencies of those that lose power, with their values.
  RatioRingPtr ringOf(const Mechanism& mechanism) {
    std::vector<std::string> names;
    std::vector<RatioRing::Teeth> values;
    for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
      names.push_back("i" + std::to_string(mechanism.meshLabel(mesh)));
      const KinematicModel::MeshRow& row = m_model.meshRow(mesh);
      values.push_back({row.tailTeeth, row.headTeeth});
    }
    constexpr double kSteps = 1'000'000;  // the values only steer the choice of pivots
    for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
      const MeshLoss& loss = m_solution.losses[mesh];
      if (loss.driver == MeshLoss::Driver::none) continue;
      m_etaOf[mesh] = static_cast<int>(names.size());
      names.push_back("eta" + std::to_string(mechanism.meshLabel(mesh)));
      values.push_back(
          {std::max(1, static_cast<int>(kSteps * loss.efficiency.toDouble())), static_cast<int>(kSteps)});
    }
    return std::make_shared<const RatioRing>(std::move(names), std::move(values));
  }

  [[nodiscard]] bool isRational() const {
    if (!m_solution.statics.selfStresses.empty() || !m_solution.statics.isDeterminate()) return false;
    for (const RadicalColumns& load : m_problem.loads) {
      if (load.count() != 1) return false;
      for (const auto& [link, factor] : load.columns().front().entries)
        if (!fits(factor)) return false;
    }
    for (const HeldPart& part : m_solution.statics.held) {
      if (!part.isExact) return false;
      for (const auto& [link, factor] : part.byLink)
        if (!fits(factor)) return false;
    }
    for (const auto& [link, factor] : m_loads.columns().front().entries)
      if (!fits(factor)) return false;
    return std::all_of(m_problem.speeds.begin(), m_problem.speeds.end(), fits);
  }

  /// All columns, the given one last at 1; none where the unknowns do not follow from it.
  [[nodiscard]] std::optional<std::vector<Function>> solved(SparseRows<Function> rows, int unknowns) const {
    const auto system = eliminate(m_field, std::move(rows), unknowns, unknowns + 1, m_enough.get_token());
    if (!system || !system->freeColumns.empty()) return std::nullopt;
    std::vector<Function> x(static_cast<std::size_t>(unknowns) + 1);
    x.back() = m_field.one();
    substitute(m_field, *system, std::span(x));
    if (m_enough.stop_requested()) return std::nullopt;
    return x;
  }

  /// phi by link, 0 for the ground.
  [[nodiscard]] std::optional<std::vector<Function>> speeds() const {
    SparseRows<Function> rows;
    for (const MeshOrdinal mesh : m_problem.meshes) {
      m_model.addMeshRow(rows, mesh, m_field, Function::variable(m_ring, mesh), m_field.one());
      rows.endRow();
    }
    for (std::size_t input = 0; input < m_problem.inputs.size(); ++input) {
      m_model.addRateRow(rows, m_problem.inputs[input], m_field);
      if (!m_problem.speeds[input].isZero()) rows.add(m_model.n(), number(-m_problem.speeds[input]));
      rows.endRow();
    }
    for (const HeldPart& part : m_solution.statics.held) {
      if (part.coupling < 0) continue;
      for (const auto& [link, factor] : part.byLink)  // what it holds together does not turn apart
        if (link != 0) rows.add(link - 1, number(factor));
      rows.endRow();
    }
    if (rows.rows() != m_model.n()) return std::nullopt;  // some follow from others by these teeth only
    auto x = solved(std::move(rows), m_model.n());
    if (!x) return std::nullopt;
    x->pop_back();
    x->insert(x->begin(), m_field.fromInteger(0));
    return x;
  }

  /// By unknown of statics: of meshes mu times the teeth of the head's gear.
  [[nodiscard]] std::optional<std::vector<Function>> unknownTorques() const {
    const auto weights = [&](MeshOrdinal mesh, bool tail) {
      const MeshLoss::Driver driver = m_solution.losses[mesh].driver;
      Function weight = tail ? Function::variable(m_ring, mesh) : m_field.one();
      const bool isDriven = driver == (tail ? MeshLoss::Driver::head : MeshLoss::Driver::tail);
      if (isDriven) weight *= Function::variable(m_ring, m_etaOf[mesh]);
      return weight;
    };
    const auto factor = [&](const Rational& value) { return number(value); };
    return solved(staticsRows(m_model, m_field, m_solution.statics.held, m_loads, weights, factor),
                  m_model.c() + static_cast<int>(m_solution.statics.held.size()));
  }

  const KinematicModel& m_model;
  const EfficiencyProblem& m_problem;
  const LossySolution& m_solution;
  const Motion& m_motion;
  std::stop_source m_enough;  ///< the caller's request, or the size of what is met
  std::stop_callback<std::function<void()>> m_forward;
  ByMesh<int> m_etaOf;  ///< the variable; -1: it loses nothing
  RatioRingPtr m_ring;
  std::int64_t m_mostTerms;
  RationalFunctionField m_field;
  RadicalColumns m_loads;  ///< all of them together
};

}  // namespace

std::optional<RationalFunction> symbolicEfficiency(const Mechanism& mechanism, const KinematicModel& model,
                                                   const EfficiencyProblem& problem,
                                                   const LossySolution& solution, const Motion& motion,
                                                   const std::stop_token& stop, std::int64_t mostTerms) {
  return Solver(mechanism, model, problem, solution, motion, mostTerms, stop).run();
}

}  // namespace geargraph
