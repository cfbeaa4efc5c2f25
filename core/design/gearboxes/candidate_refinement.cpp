#include "core/design/gearboxes/candidate_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geargraph {
namespace {

constexpr std::size_t kMaxRefinedGears = 16;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Solves the normal equations (J^T J + damping) x = J^T r of at most kMaxSets unknowns by elimination.
struct NormalEquations {
  std::array<std::array<double, kMaxSets + 1>, kMaxSets> rows{};
  std::size_t unknowns;

  explicit NormalEquations(std::size_t count) : unknowns(count) {}

  void add(std::span<const double> gradient, double residual) {
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t j = 0; j < unknowns; ++j) rows[i][j] += gradient[i] * gradient[j];
      rows[i][kMaxSets] += gradient[i] * residual;
    }
  }

  std::array<double, kMaxSets> solved(double damping) {
    for (std::size_t i = 0; i < unknowns; ++i) rows[i][i] += damping;
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t below = i + 1; below < unknowns; ++below) {
        const double factor = rows[below][i] / rows[i][i];
        for (std::size_t j = i; j < unknowns; ++j) rows[below][j] -= factor * rows[i][j];
        rows[below][kMaxSets] -= factor * rows[i][kMaxSets];
      }
    }
    std::array<double, kMaxSets> x{};
    for (std::size_t i = unknowns; i-- > 0;) {
      double sum = rows[i][kMaxSets];
      for (std::size_t j = i + 1; j < unknowns; ++j) sum -= rows[i][j] * x[j];
      x[i] = sum / rows[i][i];
    }
    return x;
  }
};

/// Differences target - log; false if a ratio has the wrong sign.
bool residualsOf(std::span<const double> ratios, std::span<const double> logs, bool negative,
                 std::span<double> residuals) {
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const double value = negative && i + 1 == logs.size() ? -ratios[i] : ratios[i];
    if (!(value > 0)) return false;
    residuals[i] = logs[i] - std::log(value);
  }
  return true;
}

double largestOf(std::span<const double> values) {
  double largest = 0;
  for (const double each : values) largest = std::max(largest, std::abs(each));
  return largest;
}

double squaresOf(std::span<const double> values) {
  double sum = 0;
  for (const double each : values) sum += each * each;
  return sum;
}

}  // namespace

bool StateRatios::at(std::span<const double> k, std::span<const std::array<ElementLinks, 3>> states,
                     std::span<double> ratios) const {
  const DoubleNumbers numbers;
  const auto space = speedSpace<DoubleNumbers>(*m_sets, *m_layout, m_shafts, k, numbers);
  if (!space) return false;
  for (std::size_t state = 0; state < states.size(); ++state) {
    std::array<std::array<double, kMaxFreedom>, 3> engaged{};
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(space->freedom); ++i)
      engaged[i] = directionOf(*space, states[state][i], numbers);
    const double in = speedWith(engaged, space->rows[m_layout->input], space->freedom, numbers);
    const double out = speedWith(engaged, space->rows[m_layout->output], space->freedom, numbers);
    ratios[state] = numbers.isZero(out) ? 0 : in / out;
  }
  return true;
}

double refineK(const StateRatios& ratios, std::span<const std::array<ElementLinks, 3>> states,
               std::span<const double> logs, bool negative, double least, double most, std::span<double> k) {
  constexpr int kMaxSteps = 16;
  constexpr double kDifference = 1e-6;
  const std::size_t count = logs.size();
  const std::size_t unknowns = k.size();
  std::array<double, kMaxRefinedGears> values{};
  std::array<double, kMaxRefinedGears> residuals{};
  std::array<std::array<double, kMaxSets>, kMaxRefinedGears> gradients{};
  const auto part = [count](std::array<double, kMaxRefinedGears>& all) {
    return std::span(all).first(count);
  };
  if (!ratios.at(k, states, part(values)) || !residualsOf(part(values), logs, negative, part(residuals)))
    return kNone;
  double squares = squaresOf(part(residuals));
  double damping = 1e-9;
  for (int step = 0; step < kMaxSteps; ++step) {
    if (step == 4 && largestOf(part(residuals)) > 0.2) return kNone;
    if (step == 8 && largestOf(part(residuals)) > 0.08) return kNone;
    for (std::size_t set = 0; set < unknowns; ++set) {
      std::array<double, kMaxSets> moved{};
      std::copy(k.begin(), k.end(), moved.begin());
      moved[set] *= 1 + kDifference;
      std::array<double, kMaxRefinedGears> other{};
      if (!ratios.at(std::span(moved).first(unknowns), states, part(other))) return kNone;
      for (std::size_t i = 0; i < count; ++i)
        gradients[i][set] = std::log(std::abs(other[i] / values[i])) / kDifference;
    }
    NormalEquations equations(unknowns);
    for (std::size_t i = 0; i < count; ++i)
      equations.add(std::span(gradients[i]).first(unknowns), residuals[i]);
    const auto move = NormalEquations(equations).solved(damping);
    std::array<double, kMaxSets> next{};
    double length = 0;
    for (std::size_t set = 0; set < unknowns; ++set) {
      next[set] = std::clamp(k[set] * std::exp(std::clamp(move[set], -0.5, 0.5)), least, most);
      length = std::max(length, std::abs(next[set] / k[set] - 1));
    }
    std::array<double, kMaxRefinedGears> nextResiduals{};
    std::array<double, kMaxRefinedGears> nextValues{};
    const bool isThere = ratios.at(std::span(next).first(unknowns), states, part(nextValues)) &&
                         residualsOf(part(nextValues), logs, negative, part(nextResiduals));
    if (!isThere || squaresOf(part(nextResiduals)) > squares * (1 + 1e-12)) {
      if (damping > 1e3 || length < 1e-10) break;
      damping = std::max(damping * 30, 1e-3);
      continue;
    }
    damping = std::max(damping / 30, 1e-9);
    std::copy_n(next.begin(), unknowns, k.begin());
    values = nextValues;
    residuals = nextResiduals;
    squares = squaresOf(part(residuals));
    if (length < 1e-10) break;
  }
  return largestOf(part(residuals));
}

}  // namespace geargraph
