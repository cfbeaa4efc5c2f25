#include "core/presentation/diagrams/bar_lengths.h"

#include <algorithm>

namespace geargraph {
namespace {

using Values = std::vector<Rational>;

/// The tableau of a linear program: unknowns that are 0 or above, equations with right sides of 0 or above,
/// and the cost to be made least in the last row. Artificial unknowns after the others are the first basis.
class Tableau {
 public:
  explicit Tableau(std::size_t unknowns) : m_unknowns(unknowns) {}

  void addEquation(Values coefficients, Rational right) {
    coefficients.resize(m_unknowns);
    if (right.sign() < 0) {
      right = -right;
      for (Rational& each : coefficients) each = -each;
    }
    coefficients.push_back(std::move(right));
    m_rows.push_back(std::move(coefficients));
  }

  /// The unknowns of the least cost. std::nullopt if the equations have no solution.
  std::optional<Values> least(const Values& cost) {
    // An artificial unknown a row, which has no column: once it has left the basis it does not come back.
    m_basis.assign(m_rows.size(), m_unknowns);
    m_cost.assign(m_unknowns + 1, Rational(0));
    for (const Values& row : m_rows) {
      for (std::size_t k = 0; k <= m_unknowns; ++k) m_cost[k] -= row[k];
    }
    improve();
    if (!m_cost.back().isZero()) return std::nullopt;
    leaveArtificial();
    m_cost = cost;
    m_cost.resize(m_unknowns + 1);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      if (m_basis[i] < m_unknowns) subtract(m_cost, Rational(m_cost[m_basis[i]]), m_rows[i]);
    }
    improve();
    Values solution(m_unknowns);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      if (m_basis[i] < m_unknowns) solution[m_basis[i]] = m_rows[i].back();
    }
    return solution;
  }

 private:
  static void subtract(Values& from, const Rational& factor, const Values& row) {
    if (factor.isZero()) return;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!row[k].isZero()) from[k] -= factor * row[k];
    }
  }

  void pivot(std::size_t row, std::size_t column) {
    const Rational scale = m_rows[row][column].inverse();
    for (Rational& each : m_rows[row]) each *= scale;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      if (i != row) subtract(m_rows[i], Rational(m_rows[i][column]), m_rows[row]);
    }
    subtract(m_cost, Rational(m_cost[column]), m_rows[row]);
    m_basis[row] = column;
  }

  /// Bland's rule. Costs here are sums of lengths, which have a least value: there is always a row to leave.
  void improve() {
    while (true) {
      std::size_t column = 0;
      while (column < m_unknowns && m_cost[column].sign() >= 0) ++column;
      if (column == m_unknowns) return;
      std::optional<std::size_t> leaving;
      Rational least;
      for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i][column].sign() <= 0) continue;
        const Rational ratio = m_rows[i].back() / m_rows[i][column];
        if (leaving && (least < ratio || (ratio == least && m_basis[*leaving] <= m_basis[i]))) continue;
        leaving = i;
        least = ratio;
      }
      if (!leaving) return;
      pivot(*leaving, column);
    }
  }

  /// Artificial unknowns that are 0 and still in the basis give way, or their equation says nothing.
  void leaveArtificial() {
    for (std::size_t i = m_rows.size(); i-- > 0;) {
      if (m_basis[i] < m_unknowns) continue;
      std::size_t column = 0;
      while (column < m_unknowns && m_rows[i][column].isZero()) ++column;
      if (column < m_unknowns) {
        pivot(i, column);
      } else {
        m_rows.erase(m_rows.begin() + static_cast<std::ptrdiff_t>(i));
        m_basis.erase(m_basis.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }

  std::size_t m_unknowns;
  std::vector<Values> m_rows;
  std::vector<std::size_t> m_basis;
  Values m_cost;
};

}  // namespace

std::optional<BarLengths> barLengths(const BarDemands& demands) {
  // Unknowns: heights of the lower ends, lengths beyond 1, the height of all, then a slack an inequality.
  const auto bars = static_cast<std::size_t>(demands.bars);
  const std::size_t height = 2 * bars;
  const std::size_t unknowns = height + 1 + bars + demands.passes.size();
  std::size_t slack = height + 1;
  Tableau tableau(unknowns);
  /// Adds the height of a spot to an equation; what is known goes to the right side.
  const auto add = [&](Values& row, Rational& right, const BarSpot& spot, int sign) {
    const auto bar = static_cast<std::size_t>(spot.bar);
    row[bar] += sign;
    row[bars + bar] += Rational(sign) * spot.part;
    right -= Rational(sign) * spot.part;
  };
  for (const auto& [one, other] : demands.level) {
    Values row(unknowns);
    Rational right;
    add(row, right, one, 1);
    add(row, right, other, -1);
    tableau.addEquation(std::move(row), std::move(right));
  }
  for (const BarDemands::Pass& pass : demands.passes) {
    Values row(unknowns);
    Rational right = barClearance();
    add(row, right, pass.spot, pass.isAbove ? 1 : -1);
    add(row, right, {pass.bar, pass.isAbove ? 1 : 0}, pass.isAbove ? -1 : 1);
    row[slack++] = -1;
    tableau.addEquation(std::move(row), std::move(right));
  }
  for (int bar = 0; bar < demands.bars; ++bar) {
    Values row(unknowns);
    Rational right;
    add(row, right, {bar, 1}, 1);
    row[height] = -1;
    row[slack++] = 1;
    tableau.addEquation(std::move(row), std::move(right));
  }
  Values cost(unknowns);
  for (std::size_t bar = 0; bar < bars; ++bar) {
    cost[bar] = 1;
    cost[bars + bar] = 1'000;
  }
  cost[height] = 1'000'000;
  const auto solution = tableau.least(cost);
  if (!solution) return std::nullopt;
  BarLengths result;
  result.height = (*solution)[height];
  for (std::size_t bar = 0; bar < bars; ++bar) {
    result.bottoms.push_back((*solution)[bar]);
    result.lengths.push_back(Rational(1) + (*solution)[bars + bar]);
  }
  return result;
}

}  // namespace geargraph
