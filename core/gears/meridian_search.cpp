#include "core/gears/meridian_search.h"

#include <algorithm>
#include <bit>

namespace geargraph {
namespace {

constexpr double kFar = 1e300;
constexpr double kShut = -1;
constexpr double kMostLots = 4096;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

MeridianSearch::MeridianSearch(const MeridianGrid& grid)
    : m_grid(grid), m_rowFactor(at(grid.rows)), m_columnAhead(at(grid.columns)), m_rowAhead(at(grid.rows)) {
  if (grid.width.empty() || grid.rowCost.empty()) return;
  const auto [narrowest, widest] = std::minmax_element(grid.width.begin(), grid.width.end());
  const double cheapest = *std::min_element(grid.rowCost.begin(), grid.rowCost.end());
  m_widest = *widest;
  m_cheapest = std::min(*narrowest * (1 + cheapest), cheapest);
}

/// Along the axis and across it each by itself, as if nothing were in the way.
void MeridianSearch::lookAhead(const Places& ends) {
  std::fill(m_columnAhead.begin(), m_columnAhead.end(), kFar);
  std::fill(m_rowAhead.begin(), m_rowAhead.end(), kFar);
  for (const auto& [cell, cost] : ends) {
    double& ahead = m_columnAhead[at(m_grid.columnOf(cell))];
    ahead = std::min(ahead, cost);
    m_rowAhead[at(m_grid.rowOf(cell))] = 0;
  }
  const double factor = *std::min_element(m_rowFactor.begin(), m_rowFactor.end());
  const auto spread = [](std::vector<double>& ahead, const auto& price) {
    for (std::size_t i = 1; i < ahead.size(); ++i) ahead[i] = std::min(ahead[i], ahead[i - 1] + price(i));
    for (std::size_t i = ahead.size() - 1; i > 0; --i)
      ahead[i - 1] = std::min(ahead[i - 1], ahead[i] + price(i - 1));
  };
  spread(m_columnAhead, [&](std::size_t c) { return m_grid.width[c] * factor; });
  spread(m_rowAhead, [&](std::size_t r) { return m_grid.rowCost[r]; });
}

/// As many lots as lie between the first front and one that was reached from it: a step costs its price, and
/// as much again where it leads away from the ends. A lot may span more than the cheapest step: its cells are
/// then settled again as cheaper ways to them are found.
void MeridianSearch::makeLots(const Places& sources) {
  double low = kFar, high = 0, dearest = 0;
  for (const auto& [cell, cost] : sources) {
    const double rank =
        cost + (m_columnAhead[at(m_grid.columnOf(cell))] + m_rowAhead[at(m_grid.rowOf(cell))]);
    low = std::min(low, rank);
    high = std::max(high, rank);
  }
  for (int r = 0; r < m_grid.rows; ++r)
    dearest = std::max({dearest, m_widest * m_rowFactor[at(r)], m_grid.rowCost[at(r)]});
  const double span = std::max(2 * dearest, high - low);
  m_perStep = std::min(1 / m_cheapest, kMostLots / span);
  const std::size_t count = std::bit_ceil(static_cast<std::size_t>(span * m_perStep) + 2);
  if (m_lots.size() < count) m_lots.resize(count);
  for (auto& some : m_lots) some.clear();
  m_waiting = 0;
  m_lot = sources.empty() ? 0 : lotOf(low);
}

void MeridianSearch::begin(int net, const std::vector<int>& owner, std::span<const double> rowExtra,
                           const Places& sources, const Places& ends) {
  for (int r = 0; r < m_grid.rows; ++r) m_rowFactor[at(r)] = 1 + m_grid.rowCost[at(r)] + rowExtra[at(r)];
  lookAhead(ends);
  makeLots(sources);
  m_from.resize(owner.size());
  m_cost.resize(owner.size());
  for (std::size_t c = 0; c < owner.size(); ++c)
    m_cost[c] = owner[c] == MeridianGrid::kFree || owner[c] == net ? kFar : kShut;
  for (const auto& [cell, cost] : sources) {
    if (cost >= m_cost[at(cell)]) continue;
    m_cost[at(cell)] = cost;
    m_from[at(cell)] = -1;
    push(cost, cell, m_grid.columnOf(cell));
  }
}

const std::vector<int>& MeridianSearch::settleLot() {
  m_settled.clear();
  while (lot(m_lot).empty()) ++m_lot;
  auto& fronts = lot(m_lot);
  for (std::size_t i = 0; i < fronts.size(); ++i) {  // more may come
    const Front front = fronts[i];
    if (front.cost > m_cost[at(front.cell)]) continue;  // it was reached more cheaply before
    m_settled.push_back(front.cell);
    relax(front);
  }
  m_waiting -= fronts.size();
  fronts.clear();
  ++m_lot;
  return m_settled;
}

inline void MeridianSearch::reach(const Front& before, int cell, int column, double price) {
  double& known = m_cost[at(cell)];
  const double cost = before.cost + price;
  if (cost > known) return;
  int& from = m_from[at(cell)];
  if (cost < known) {
    known = cost;
    from = before.cell;
    push(cost, cell, column);
  } else if (from >= 0 && std::pair(before.cost, before.cell) < std::pair(m_cost[at(from)], from)) {
    from = before.cell;
  }
}

void MeridianSearch::relax(const Front& front) {
  const int row = front.cell - front.column * m_grid.rows;
  const double along = m_grid.width[at(front.column)] * m_rowFactor[at(row)];
  if (front.column > 0) reach(front, front.cell - m_grid.rows, front.column - 1, along);
  if (front.column + 1 < m_grid.columns) reach(front, front.cell + m_grid.rows, front.column + 1, along);
  if (!m_grid.plates[at(front.column)]) return;
  if (row > 0) reach(front, front.cell - 1, front.column, m_grid.rowCost[at(row)]);
  if (row + 1 < m_grid.rows) reach(front, front.cell + 1, front.column, m_grid.rowCost[at(row)]);
}

}  // namespace geargraph
