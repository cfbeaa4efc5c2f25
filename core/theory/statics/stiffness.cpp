#include "core/theory/statics/stiffness.h"

#include <algorithm>

namespace geargraph {
namespace {

/// By mesh, the square of F_c / mu_c, up to a common factor: N_tail / radius, or 1 where a radius is
/// irrational.
std::vector<Rational> squaresPerTooth(const KinematicModel& model, const CoefficientMatrix& matrix) {
  std::vector<Rational> squares;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const auto radius = matrix.exactRadius(mesh, true);
    if (!radius) return std::vector<Rational>(static_cast<std::size_t>(model.c()), Rational(1));
    const Rational perTooth = Rational(model.meshRow(mesh).tailTeeth) / *radius;
    squares.push_back(perTooth * perTooth);
  }
  return squares;
}

}  // namespace

bool shareByStiffness(const KinematicModel& model, const CoefficientMatrix& matrix, StaticsSolution& solution,
                      const std::stop_token& stop) {
  const auto count = solution.selfStresses.size();
  if (count == 0) return true;
  const std::vector<Rational> squares = squaresPerTooth(model, matrix);
  const auto member = [&](std::size_t stress, int unknown) -> const Rational* {
    const auto& members = solution.selfStresses[stress];
    const auto found = std::lower_bound(members.begin(), members.end(), unknown,
                                        [](const auto& each, int of) { return each.first < of; });
    return found != members.end() && found->first == unknown ? &found->second : nullptr;
  };
  // Normal equations: sum over b of (s_a . s_b) x_b = -(s_a . values), one unit at a time on the right, so
  // that their coefficients stay fractions where the loads are irrational.
  const RationalField field;
  SparseRows<Rational> rows;
  std::vector<Real> start(count);
  for (std::size_t a = 0; a < count; ++a) {
    if (stop.stop_requested()) return false;
    std::vector<Rational> products(count);
    for (const auto& [unknown, weight] : solution.selfStresses[a]) {
      if (unknown >= model.c()) continue;
      const Rational scaled = weight * squares[static_cast<std::size_t>(unknown)];
      start[a] += Real(scaled) * solution.values[static_cast<std::size_t>(unknown)];
      for (std::size_t b = 0; b < count; ++b) {
        if (const Rational* other = member(b, unknown)) products[b] += scaled * *other;
      }
    }
    for (std::size_t b = 0; b < count; ++b)
      if (!products[b].isZero()) rows.add(static_cast<int>(b), products[b]);
    rows.add(static_cast<int>(count + a), Rational(1));
    rows.endRow();
  }
  const auto system =
      eliminate(field, std::move(rows), static_cast<int>(count), static_cast<int>(2 * count), stop);
  if (!system) return false;
  if (!system->freeColumns.empty()) return true;  // couplings alone hold each other: no share to tell
  for (std::size_t a = 0; a < count; ++a) {
    std::vector<Rational> x(2 * count, Rational(0));
    x[count + a] = 1;
    substitute(field, *system, x);
    for (std::size_t b = 0; b < count; ++b) {
      const Real amount = Real(x[b]) * start[a];
      for (const auto& [unknown, weight] : solution.selfStresses[b])
        solution.values[static_cast<std::size_t>(unknown)] += Real(weight) * amount;
    }
  }
  std::fill(solution.determined.begin(), solution.determined.end(), 1);
  return true;
}

}  // namespace geargraph
