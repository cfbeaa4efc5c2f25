#include "core/theory/statics/shared_loads.h"

#include <algorithm>

#include "core/foundations/exact/linear_maximum.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxStresses = 12;  ///< self-stresses for which ranges are found
constexpr int kMaxPivots = 200;

/// As a fraction: rounded where it is not one.
Rational fractionOf(const Real& value) {
  return value.isExact() ? *value.fraction() : Rational::fromDouble(value.number());
}

/// The amounts of the self-stresses that may be added to a solution, as the unknowns of a linear program.
class Sharings {
 public:
  Sharings(const KinematicModel& model, const LossySolution& solution)
      : m_model(model), m_solution(solution) {}

  /// False where the drivers of some mesh leave it no sign.
  bool prepare() {
    const StaticsSolution& statics = m_solution.statics;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      const std::vector<Rational> weights = weightsOf(mesh);
      const bool isMember = std::any_of(weights.begin(), weights.end(),
                                        [](const Rational& weight) { return !weight.isZero(); });
      if (!isMember || m_solution.powers.rolls[mesh] == 0) continue;
      const Real& value = statics.values[static_cast<std::size_t>(mesh)];
      if (value.isZero()) return false;
      LinearBound bound{weights, fractionOf(value.abs())};
      if (value.sign() > 0)
        for (Rational& weight : bound.coefficients) weight = -weight;
      m_bounds.push_back(std::move(bound));
    }
    return true;
  }

  [[nodiscard]] std::optional<SharedRange> rangeOf(int unknown) const {
    std::vector<Rational> weights = weightsOf(unknown);
    const Real& value = m_solution.statics.values[static_cast<std::size_t>(unknown)];
    if (std::all_of(weights.begin(), weights.end(), [](const Rational& each) { return each.isZero(); }))
      return SharedRange{value, value};
    const auto above = linearMaximum(m_bounds, weights, kMaxPivots);
    for (Rational& weight : weights) weight = -weight;
    const auto below = above ? linearMaximum(m_bounds, weights, kMaxPivots) : std::nullopt;
    if (!below) return std::nullopt;
    return SharedRange{value - Real(*below), value + Real(*above)};
  }

 private:
  /// The part of an unknown in each self-stress.
  [[nodiscard]] std::vector<Rational> weightsOf(int unknown) const {
    std::vector<Rational> weights;
    for (const auto& members : m_solution.statics.selfStresses) {
      const auto found = std::find_if(members.begin(), members.end(),
                                      [&](const auto& member) { return member.first == unknown; });
      weights.push_back(found == members.end() ? Rational(0) : found->second);
    }
    return weights;
  }

  const KinematicModel& m_model;
  const LossySolution& m_solution;
  std::vector<LinearBound> m_bounds;
};

}  // namespace

std::optional<std::vector<char>> dependsOnShares(const KinematicModel& model, const StaticsSolution& lossless,
                                                 const RadicalColumns& loads,
                                                 std::span<const MeshLoss> losses,
                                                 const std::stop_token& stop) {
  std::vector<char> depends(static_cast<std::size_t>(lossless.unknowns), 0);
  const auto mark = [&](const StaticsSolution& solution) {
    for (const auto& members : solution.selfStresses)
      for (const auto& [unknown, weight] : members) depends[static_cast<std::size_t>(unknown)] = 1;
  };
  mark(lossless);
  if (losses.empty()) return depends;
  // Equal losses may cancel in a null vector although another distribution has other drivers: so each member
  // loses a part of its own.
  std::vector<MeshLoss> different(losses.begin(), losses.end());
  int number = 10;
  for (std::size_t mesh = 0; mesh < different.size(); ++mesh)
    if (depends[mesh] != 0) {
      different[mesh].efficiency = Rational(number, number + 1);
      ++number;
    }
  const auto solution = solveStatics(model, lossless.held, loads, different, stop);
  if (!solution) return std::nullopt;
  mark(*solution);
  return depends;
}

std::vector<std::optional<SharedRange>> sharedRanges(const KinematicModel& model,
                                                     const LossySolution& solution) {
  std::vector<std::optional<SharedRange>> ranges(solution.statics.held.size());
  if (solution.statics.selfStresses.size() > kMaxStresses) return ranges;
  Sharings sharings(model, solution);
  if (!sharings.prepare()) return ranges;
  for (std::size_t part = 0; part < ranges.size(); ++part)
    ranges[part] = sharings.rangeOf(model.c() + static_cast<int>(part));
  return ranges;
}

}  // namespace geargraph
