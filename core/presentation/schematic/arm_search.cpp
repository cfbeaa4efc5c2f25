#include "core/presentation/schematic/arm_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace geargraph {
namespace {

constexpr double kBend = 30;
constexpr double kRounding = 1e-6;  ///< far more than sums of costs are off
/// A state leads nowhere that costs so much more than the other one of its node.
constexpr double kOther = kBend + kRounding;
constexpr std::size_t kAbreast = 4;  ///< rows at a time, since each waits for its own sums

}  // namespace

void ArmSearch::begin(const ArmGrid& grid, const ArmEdgeWeights& weights) {
  m_grid = &grid;
  m_weights = &weights;
  m_level.assign(grid.nodes(), kFar);
  m_upright.assign(grid.nodes(), kFar);
  m_start.assign(grid.nodes(), kFar);
  m_pending.assign(grid.rows(), {});
  m_targets.clear();
  m_most = kFar;
}

void ArmSearch::addStart(std::size_t node, double penalty) {
  if (penalty >= m_start[node]) return;
  m_start[node] = m_level[node] = m_upright[node] = penalty;
  m_pending[node / m_grid->columns()] = {true, true, true};
}

void ArmSearch::addTarget(std::size_t node, double price, std::size_t number) {
  for (Target& target : m_targets) {
    if (target.node != node) continue;
    if (price < target.price) target = {node, price, number};
    return;
  }
  m_targets.push_back({node, price, number});
}

/// As if nothing were in the way.
void ArmSearch::lookAhead() {
  m_columnAhead.assign(m_grid->columns(), kFar);
  m_rowAhead.assign(m_grid->rows(), kFar);
  for (const Target& target : m_targets) {
    const CanvasPoint place = m_grid->place(target.node);
    for (std::size_t c = 0; c < m_grid->columns(); ++c)
      m_columnAhead[c] = std::min(m_columnAhead[c], std::abs(m_grid->xs[c] - place.x) + target.price);
    for (std::size_t r = 0; r < m_grid->rows(); ++r)
      m_rowAhead[r] = std::min(m_rowAhead[r], std::abs(m_grid->ys[r] - place.y));
  }
}

/// Ways that cost more than one that is known need not be followed.
void ArmSearch::narrow() {
  for (const Target& target : m_targets) {
    const double cost = std::min(m_level[target.node], m_upright[target.node]) + target.price;
    m_most = std::min(m_most, cost + kRounding);
  }
}

/// Along all rows that have it pending.
void ArmSearch::goLevel() {
  m_rows.clear();
  for (std::size_t r = 0; r < m_grid->rows(); ++r) {
    if (m_pending[r].level) m_rows.push_back(r);
  }
  for (std::size_t i = 0; i < m_rows.size(); i += kAbreast)
    alongRows(m_rows.data() + i, std::min(kAbreast, m_rows.size() - i));
}

void ArmSearch::alongRows(const std::size_t* rows, std::size_t count) {
  const std::size_t columns = m_grid->columns();
  struct Row {
    double* level;
    const double* upright;
    const double* weights;
    double most;
    bool isNew;
  };
  std::array<Row, kAbreast> each;
  for (std::size_t k = 0; k < kAbreast; ++k) {
    const std::size_t r = rows[std::min(k, count - 1)];  // the last one again does no harm
    const std::size_t first = r * columns;
    each[k] = {m_level.data() + first, m_upright.data() + first, m_weights->level.data() + first,
               m_most - m_rowAhead[r], false};
  }
  const auto step = [&](Row& row, std::size_t from, std::size_t to, double length, double weight) {
    const double straight = row.level[from] + length + weight;
    const double bent = row.upright[from] + length + kBend + weight;
    const double cost = std::min(straight, bent);
    const double known = row.level[to];
    const double worth = std::min({known, row.most - m_columnAhead[to], row.upright[to] + kOther});
    row.isNew |= cost < worth;
    row.level[to] = std::min(cost, known);
  };
  for (std::size_t c = 0; c + 1 < columns; ++c) {
    const double length = m_grid->xs[c + 1] - m_grid->xs[c];
    for (Row& row : each) step(row, c, c + 1, length, row.weights[c]);
  }
  for (std::size_t c = columns - 1; c > 0; --c) {
    const double length = m_grid->xs[c] - m_grid->xs[c - 1];
    for (Row& row : each) step(row, c, c - 1, length, row.weights[c - 1]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    Pending& pending = m_pending[rows[k]];
    pending.level = false;
    pending.down = pending.down || each[k].isNew;
    pending.up = pending.up || each[k].isNew;
  }
}

/// From a row to the next one. What gets cheaper there goes on the same way, and along the row; back again
/// would be a detour.
void ArmSearch::acrossRows(std::size_t from, std::size_t to, double length, const double* weights,
                           bool Pending::*onward) {
  const std::size_t columns = m_grid->columns();
  const double* const level = m_level.data() + from * columns;
  const double* const upright = m_upright.data() + from * columns;
  const double* const other = m_level.data() + to * columns;
  double* const next = m_upright.data() + to * columns;
  const double* const ahead = m_columnAhead.data();
  const double most = m_most - m_rowAhead[to];
  std::int64_t signs = 0;  // of all differences: so several columns are done at a time
  for (std::size_t c = 0; c < columns; ++c) {
    const double bent = level[c] + length + kBend + weights[c];
    const double straight = upright[c] + length + weights[c];
    const double cost = bent < straight ? bent : straight;
    const double known = next[c], within = most - ahead[c], useful = other[c] + kOther;
    const double least = within < useful ? within : useful;
    const double worth = known < least ? known : least;
    signs |= std::bit_cast<std::int64_t>(cost - worth);
    next[c] = cost < known ? cost : known;
  }
  m_pending[from].*onward = false;
  if (signs >= 0) return;  // nothing got cheaper
  m_pending[to].*onward = true;
  m_pending[to].level = true;
}

/// The state before this one on its cheapest way; none at its start. Of several it is the cheapest, then the
/// first.
std::optional<std::size_t> ArmSearch::before(std::size_t state) const {
  const std::size_t node = state / 2, columns = m_grid->columns();
  const std::size_t column = node % columns, row = node / columns;
  if (m_start[node] == costOf(state)) return std::nullopt;
  std::optional<std::size_t> best;
  double least = kFar;
  const auto consider = [&](std::size_t neighbour, double length, double weight) {
    for (const std::size_t way : {0, 1}) {
      const std::size_t from = 2 * neighbour + way;
      const double cost = costOf(from) + length + (way == state % 2 ? 0 : kBend) + weight;
      if (cost == kFar || cost > least || (cost == least && costOf(from) >= costOf(*best))) continue;
      least = cost;
      best = from;
    }
  };
  if (state % 2 == 0) {
    if (column > 0)
      consider(node - 1, m_grid->xs[column] - m_grid->xs[column - 1], m_weights->level[node - 1]);
    if (column + 1 < columns)
      consider(node + 1, m_grid->xs[column + 1] - m_grid->xs[column], m_weights->level[node]);
  } else {
    if (row > 0)
      consider(node - columns, m_grid->ys[row] - m_grid->ys[row - 1], m_weights->upright[node - columns]);
    if (row + 1 < m_grid->rows())
      consider(node + columns, m_grid->ys[row + 1] - m_grid->ys[row], m_weights->upright[node]);
  }
  return best;
}

void ArmSearch::goAcross() {
  const std::size_t last = m_grid->rows() - 1, columns = m_grid->columns();
  const auto length = [&](std::size_t row) { return m_grid->ys[row + 1] - m_grid->ys[row]; };
  const auto weights = [&](std::size_t row) { return m_weights->upright.data() + row * columns; };
  for (std::size_t r = 0; r < last; ++r) {
    if (m_pending[r].down) acrossRows(r, r + 1, length(r), weights(r), &Pending::down);
  }
  for (std::size_t r = last; r > 0; --r) {
    if (m_pending[r].up) acrossRows(r, r - 1, length(r - 1), weights(r - 1), &Pending::up);
  }
  m_pending[last].down = m_pending[0].up = false;
}

/// Where the cheapest way ends: the cheapest state, then the first, those at targets without a price before
/// the targets with one.
std::optional<ArmSearch::End> ArmSearch::cheapestEnd() const {
  std::optional<End> best;
  for (const Target& target : m_targets) {
    for (const std::size_t state : {2 * target.node, 2 * target.node + 1}) {
      const double cost = costOf(state);
      const std::size_t rank = target.price == 0 ? state : 2 * m_grid->nodes() + target.number;
      const End end{cost + target.price, rank, cost, state, target.number};
      if (cost < kFar && (!best || end < *best)) best = end;
    }
  }
  return best;
}

std::optional<ArmSearch::Way> ArmSearch::cheapest(const std::stop_token& stop) {
  if (m_targets.empty()) return std::nullopt;
  lookAhead();
  narrow();
  const auto isPending = [](const Pending& pending) { return pending.level || pending.down || pending.up; };
  while (std::any_of(m_pending.begin(), m_pending.end(), isPending)) {
    if (stop.stop_requested()) return std::nullopt;
    goLevel();
    narrow();
    goAcross();
    narrow();
  }
  const std::optional<End> end = cheapestEnd();
  if (!end) return std::nullopt;
  Way way{{}, end->target};
  // Costs so large that a step vanishes in them could lead back to where the walk has been.
  for (std::optional<std::size_t> state = end->state; state; state = before(*state)) {
    if (way.nodes.size() > 2 * m_grid->nodes()) return std::nullopt;
    way.nodes.push_back(*state / 2);
  }
  std::reverse(way.nodes.begin(), way.nodes.end());
  return way;
}

}  // namespace geargraph
