#include "core/theory/statics/statics_solution.h"

#include <algorithm>

#include "core/foundations/exact/sparse_expansion.h"
#include "core/theory/matroid/structure.h"
#include "core/theory/statics/statics_system.h"

namespace geargraph {
namespace {

/// The weights of the two gears of a mesh: teeth, times the efficiency on the driven side.
struct LossyTeeth {
  const KinematicModel& model;
  std::span<const MeshLoss> losses;

  Rational operator()(MeshOrdinal mesh, bool tail) const {
    const KinematicModel::MeshRow& row = model.meshRow(mesh);
    const Rational teeth = tail ? row.tailTeeth : row.headTeeth;
    if (losses.empty()) return teeth;
    const MeshLoss& loss = losses[static_cast<std::size_t>(mesh)];
    const auto driven = tail ? MeshLoss::Driver::head : MeshLoss::Driver::tail;
    return loss.driver == driven ? teeth * loss.efficiency : teeth;
  }
};

std::optional<Elimination<Rational>> eliminated(const KinematicModel& model, std::span<const HeldPart> held,
                                                const RadicalColumns& loads, std::span<const MeshLoss> losses,
                                                const std::stop_token& stop) {
  const RationalField field;
  const auto same = [](const Rational& factor) { return factor; };
  const int unknowns = model.c() + static_cast<int>(held.size());
  return eliminate(field, staticsRows(model, field, held, loads, LossyTeeth{model, losses}, same), unknowns,
                   unknowns + loads.count(), stop);
}

/// A motion that meshes and held parts allow, on which the loads do work; of several that of the fewest
/// joints.
std::optional<FreeMotion> unheldMotion(const KinematicModel& model, std::span<const HeldPart> held,
                                       const RadicalColumns& loads, const std::stop_token& stop) {
  const RationalField field;
  SparseRows<Rational> rows = equationRows(model, field, model.c());
  for (const HeldPart& part : held) {
    for (const auto& [link, factor] : part.byLink) rows.add(link - 1, factor);
    rows.endRow();
  }
  const auto system = eliminate(field, std::move(rows), model.n(), model.n(), stop);
  if (!system) return std::nullopt;
  std::optional<FreeMotion> best;
  std::vector<Rational> phi(static_cast<std::size_t>(model.n()));
  for (const int free : system->freeColumns) {
    if (stop.stop_requested()) return std::nullopt;
    std::fill(phi.begin(), phi.end(), Rational(0));
    phi[static_cast<std::size_t>(free)] = 1;
    substitute(field, *system, phi);
    const auto isWork = [&](const RadicalColumns::Column& load) {
      Rational power = 0;
      for (const auto& [link, force] : load.entries) power += force * phi[static_cast<std::size_t>(link) - 1];
      return !power.isZero();
    };
    if (std::none_of(loads.columns().begin(), loads.columns().end(), isWork)) continue;
    FreeMotion motion;
    for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
      motion.rates.push_back(model.rateOf(field, joint, phi));
      if (!motion.rates.back().isZero()) motion.joints.push_back(joint);
    }
    if (!best || motion.joints.size() < best->joints.size()) best = std::move(motion);
  }
  return best;
}

/// Fills in a solution from an eliminated system.
class Reader {
 public:
  Reader(const Elimination<Rational>& system, const RadicalColumns& loads, StaticsSolution& solution)
      : m_system(system), m_loads(loads), m_solution(solution) {}

  /// False where the loads are not held.
  bool readValues() {
    const auto columns = static_cast<std::size_t>(m_loads.count());
    std::vector<std::vector<Rational>> parts(static_cast<std::size_t>(m_system.unknowns));
    for (std::size_t k = 0; k < columns; ++k) {
      std::vector<Rational> x(static_cast<std::size_t>(m_system.columns), Rational(0));
      x[static_cast<std::size_t>(m_system.unknowns) + k] = 1;
      substitute(m_field, m_system, x);
      for (const auto& check : m_system.checks) {
        if (!m_field.isZero(checkValue(m_field, m_system, check, x))) return false;
      }
      for (std::size_t unknown = 0; unknown < parts.size(); ++unknown)
        parts[unknown].push_back(std::move(x[unknown]));
    }
    for (const std::vector<Rational>& each : parts) {
      const Real value = m_loads.sumOf(each);
      m_solution.values.push_back(m_solution.isExact || value.isZero() ? value
                                                                       : Real::inexact(value.number()));
    }
    return true;
  }

  void readSelfStresses() {
    std::vector<Rational> x(static_cast<std::size_t>(m_system.columns));
    for (const int free : m_system.freeColumns) {
      std::fill(x.begin(), x.end(), Rational(0));
      x[static_cast<std::size_t>(free)] = 1;
      substitute(m_field, m_system, x);
      auto& members = m_solution.selfStresses.emplace_back();
      for (int unknown = 0; unknown < m_system.unknowns; ++unknown) {
        if (x[static_cast<std::size_t>(unknown)].isZero()) continue;
        members.emplace_back(unknown, x[static_cast<std::size_t>(unknown)]);
        m_solution.determined[static_cast<std::size_t>(unknown)] = 0;
      }
    }
  }

 private:
  RationalField m_field;
  const Elimination<Rational>& m_system;
  const RadicalColumns& m_loads;
  StaticsSolution& m_solution;
};

}  // namespace

std::optional<StaticsSolution> solveStatics(const KinematicModel& model, std::vector<HeldPart> held,
                                            const RadicalColumns& loads, std::span<const MeshLoss> losses,
                                            const std::stop_token& stop) {
  const auto system = eliminated(model, held, loads, losses, stop);
  if (!system) return std::nullopt;
  StaticsSolution solution;
  solution.equations = model.n();
  solution.unknowns = system->unknowns;
  solution.rank = system->rank();
  solution.isExact = std::all_of(held.begin(), held.end(), [](const HeldPart& part) { return part.isExact; });
  solution.determined.assign(static_cast<std::size_t>(system->unknowns), 1);
  Reader reader(*system, loads, solution);
  reader.readSelfStresses();
  if (!reader.readValues()) {
    solution.values.clear();
    solution.unheld = unheldMotion(model, held, loads, stop).value_or(FreeMotion{});
  }
  solution.held = std::move(held);
  if (stop.stop_requested()) return std::nullopt;
  return solution;
}

std::optional<TorqueMatrix> torqueMatrix(const KinematicModel& model, std::span<const HeldPart> held,
                                         std::span<const int> loaded, const std::stop_token& stop) {
  TorqueMatrix matrix;
  for (std::size_t part = 0; part < held.size(); ++part)
    if (held[part].balance >= 0) matrix.balanced.push_back(static_cast<int>(part));
  matrix.loaded.assign(loaded.begin(), loaded.end());
  matrix.entries.resize(matrix.balanced.size() * loaded.size());

  // One given column a loaded joint: the columns of an identity.
  const RationalField field;
  const auto system = [&] {
    const RadicalColumns none;
    const auto same = [](const Rational& factor) { return factor; };
    SparseRows<Rational> rows = staticsRows(model, field, held, none, LossyTeeth{model, {}}, same);
    const int unknowns = model.c() + static_cast<int>(held.size());
    std::vector<std::vector<std::pair<int, int>>> given(static_cast<std::size_t>(model.n()));
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      const KinematicModel::JointRate& rate = model.jointRate(loaded[k]);
      const int column = unknowns + static_cast<int>(k);
      given[static_cast<std::size_t>(rate.child) - 1].emplace_back(column, -rate.sign);
      if (rate.parent != 0) given[static_cast<std::size_t>(rate.parent) - 1].emplace_back(column, rate.sign);
    }
    SparseRows<Rational> all;
    for (int row = 0; row < rows.rows(); ++row) {
      for (int entry = rows.begin(row); entry < rows.end(row); ++entry)
        all.add(rows.column(entry), rows.value(entry));
      for (const auto& [column, sign] : given[static_cast<std::size_t>(row)]) all.add(column, Rational(sign));
      all.endRow();
    }
    return eliminate(field, std::move(all), unknowns, unknowns + static_cast<int>(loaded.size()), stop);
  }();
  if (!system) return std::nullopt;
  for (const int free : system->freeColumns) {
    std::vector<Rational> x(static_cast<std::size_t>(system->columns), Rational(0));
    x[static_cast<std::size_t>(free)] = 1;
    substitute(field, *system, x);
    for (const int part : matrix.balanced)
      if (!x[static_cast<std::size_t>(model.c() + part)].isZero()) return std::nullopt;
  }
  std::vector<Rational> x(static_cast<std::size_t>(system->columns));
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    if (stop.stop_requested()) return std::nullopt;
    std::fill(x.begin(), x.end(), Rational(0));
    x[static_cast<std::size_t>(system->unknowns) + k] = 1;
    substitute(field, *system, x);
    for (const auto& check : system->checks)
      if (!field.isZero(checkValue(field, *system, check, x))) return std::nullopt;
    for (std::size_t row = 0; row < matrix.balanced.size(); ++row)
      matrix.entries[row * loaded.size() + k] = x[static_cast<std::size_t>(model.c() + matrix.balanced[row])];
  }
  return matrix;
}

}  // namespace geargraph
