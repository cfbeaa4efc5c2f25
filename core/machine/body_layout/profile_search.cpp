#include "core/machine/body_layout/profile_search.h"

#include <algorithm>
#include <bit>

namespace geargraph {
namespace {

constexpr double kFar = ProfileOwners::kFar;
constexpr double kMaxBuckets = 4096;

}  // namespace

ProfileBits::ProfileBits(const ProfileGrid& grid)
    : m_perColumn((static_cast<std::size_t>(grid.rows) + 63) / 64),
      m_words(static_cast<std::size_t>(grid.columns) * m_perColumn) {
  m_places.reserve(grid.owner.size());
  for (std::size_t column = 0; column < static_cast<std::size_t>(grid.columns); ++column) {
    for (std::size_t row = 0; row < static_cast<std::size_t>(grid.rows); ++row) {
      const std::size_t word = column * m_perColumn + row / 64;
      m_places.push_back({static_cast<std::uint32_t>(word), static_cast<int>(row % 64)});
    }
  }
}

ProfileOwners::ProfileOwners(const ProfileGrid& grid, const ProfileBits& bits)
    : m_bits(&bits), m_owner(grid.owner), m_free(bits.words(), 0), m_costs(grid.owner.size(), kShut) {
  for (CellOrdinal cell = 0; cell < static_cast<int>(m_owner.size()); ++cell) {
    if (of(cell) == ProfileGrid::kFree) set(cell, ProfileGrid::kFree);
  }
}

void ProfileOwners::set(CellOrdinal cell, int owner) {
  const bool isFree = owner == ProfileGrid::kFree;
  const std::uint64_t bit = m_bits->bitOf(cell);
  std::uint64_t& word = m_free[m_bits->wordOf(cell)];
  m_owner[cell] = owner;
  m_costs[cell] = isFree ? kFar : kShut;
  word = isFree ? word | bit : word & ~bit;
}

bool ProfileOwners::isFree(const ProfileRun& run) const {
  for (CellOrdinal cell = run.first; cell < run.end;) {  // word by word
    const int place = m_bits->placeOf(cell);
    const int count = std::min(run.end - cell, 64 - place);
    const std::uint64_t mask = (~std::uint64_t{0} >> (64 - count)) << place;
    if ((m_free[m_bits->wordOf(cell)] & mask) != mask) return false;
    cell += count;
  }
  return true;
}

ProfileSearch::ProfileSearch(const ProfileGrid& grid)
    : m_grid(grid),
      m_columnAhead(static_cast<std::size_t>(grid.columns)),
      m_rowAhead(static_cast<std::size_t>(grid.rows)),
      m_plates(grid.plates.begin(), grid.plates.end()) {
  for (const double cost : grid.rowCost) m_rowFactor.push_back(1 + cost);
  if (grid.width.empty() || grid.rowCost.empty()) return;
  const auto [narrowest, widest] = std::minmax_element(grid.width.begin(), grid.width.end());
  const double cheapest = *std::min_element(grid.rowCost.begin(), grid.rowCost.end());
  m_widest = *widest;
  m_cheapest = std::min(*narrowest * (1 + cheapest), cheapest);
}

/// Along the axis and across it each by itself, as if nothing were in the way.
void ProfileSearch::lookAhead(const Places& ends) {
  std::fill(m_columnAhead.begin(), m_columnAhead.end(), kFar);
  std::fill(m_rowAhead.begin(), m_rowAhead.end(), kFar);
  for (const auto& [cell, cost] : ends) {
    double& ahead = m_columnAhead[m_grid.columnOf(cell)];
    ahead = std::min(ahead, cost);
    m_rowAhead[m_grid.rowOf(cell)] = 0;
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

/// As many buckets as lie between the first front and one that was reached from it: a step costs its price,
/// and as much again where it leads away from the ends. A bucket may span more than the cheapest step: its
/// cells are then settled again as cheaper ways to them are found.
void ProfileSearch::makeBuckets(const Places& sources) {
  double low = kFar, high = 0, highestCost = 0;
  for (const auto& [cell, cost] : sources) {
    const double rank = cost + (m_columnAhead[m_grid.columnOf(cell)] + m_rowAhead[m_grid.rowOf(cell)]);
    low = std::min(low, rank);
    high = std::max(high, rank);
  }
  for (int r = 0; r < m_grid.rows; ++r)
    highestCost = std::max({highestCost, m_widest * m_rowFactor[r], m_grid.rowCost[r]});
  highestCost += *std::max_element(m_extra.begin(), m_extra.end());
  const double span = std::max(2 * highestCost, high - low);
  m_perStep = std::min(1 / m_cheapest, kMaxBuckets / span);
  m_buckets.assign(std::bit_ceil(static_cast<std::size_t>(span * m_perStep) + 2), -1);
  m_fronts.clear();
  m_waiting = 0;
  m_bucket = sources.empty() ? 0 : bucketOf(low);
}

namespace {

/// Bits from those of `some` on, as far as those of `open` are set one beside the other.
std::uint64_t filled(std::uint64_t some, std::uint64_t open) {
  std::uint64_t up = open, down = open;
  for (int step = 1; step < 64; step *= 2) {
    some |= (up & (some << step)) | (down & (some >> step));
    up &= up << step;
    down &= down >> step;
  }
  return some;
}

}  // namespace

/// From the joined cells of a column to those that hang together with them in it.
void ProfileSearch::fill(std::size_t column) {
  std::uint64_t* const joined = m_joined.data() + column * m_perColumn;
  const std::uint64_t* const open = m_open.data() + column * m_perColumn;
  for (std::size_t w = 0; w < m_perColumn; ++w) {
    if (w > 0) joined[w] |= open[w] & (joined[w - 1] >> 63);
    if (joined[w] != 0 && joined[w] != open[w]) joined[w] = filled(joined[w], open[w]);
  }
  for (std::size_t w = m_perColumn - 1; w-- > 0;) {
    const std::uint64_t more = open[w] & ~joined[w] & (joined[w + 1] << 63);
    if (more != 0) joined[w] = filled(joined[w] | more, open[w]);
  }
}

/// From the joined cells of a column to those beside them, in it and in its neighbours: is any of these new?
bool ProfileSearch::spread(std::size_t column) {
  if (m_isSpread[column] != 0) return false;
  m_isSpread[column] = 1;
  if (m_plates[column] != 0) fill(column);
  const std::size_t first = column * m_perColumn;
  bool isNew = false;
  const auto join = [&](std::size_t beside) {
    for (std::size_t w = 0; w < m_perColumn; ++w) {
      std::uint64_t& there = m_joined[beside * m_perColumn + w];
      const std::uint64_t more = m_joined[first + w] & m_open[beside * m_perColumn + w] & ~there;
      if (more == 0) continue;
      there |= more;
      m_isSpread[beside] = 0;
      isNew = true;
    }
  };
  if (column > 0) join(column - 1);
  if (column + 1 < m_isSpread.size()) join(column + 1);
  return isNew;
}

/// A search that finds nothing goes through all cells there are; whether anything can be found, a few words
/// of bits tell.
bool ProfileSearch::isJoined(const ProfileBits& bits, const Places& sources, const Places& ends) {
  m_joined.assign(m_open.size(), 0);
  m_isSpread.assign(static_cast<std::size_t>(m_grid.columns), 1);
  for (const auto& [cell, cost] : sources) {
    const std::size_t word = bits.wordOf(cell);
    m_joined[word] |= bits.bitOf(cell) & m_open[word];
    m_isSpread[word / m_perColumn] = 0;
  }
  const auto isReached = [&] {
    return std::any_of(ends.begin(), ends.end(), [&](const auto& end) {
      return (m_joined[bits.wordOf(end.first)] & bits.bitOf(end.first)) != 0;
    });
  };
  const std::size_t columns = m_isSpread.size();
  for (bool isNew = true; isNew;) {
    isNew = false;
    for (std::size_t c = 0; c < columns; ++c) isNew = spread(c) || isNew;
    for (std::size_t c = columns; c-- > 0;) isNew = spread(c) || isNew;
    if (isReached()) return true;
  }
  return false;
}

bool ProfileSearch::begin(const ProfileOwners& owners,
                          std::initializer_list<std::span<const CellOrdinal>> own,
                          OrdinalSpan<CellTag, const double> extra, const Places& sources,
                          const Places& ends) {
  const ProfileBits& bits = owners.bits();
  m_perColumn = bits.perColumn();
  m_open = owners.freeBits();
  for (const auto& cells : own) {
    for (const CellOrdinal cell : cells) m_open[bits.wordOf(cell)] |= bits.bitOf(cell);
  }
  if (!isJoined(bits, sources, ends)) return false;
  m_cost = owners.costs();
  for (const auto& cells : own) {
    for (const CellOrdinal cell : cells) m_cost[cell] = kFar;
  }
  m_extra = extra;
  lookAhead(ends);
  makeBuckets(sources);
  m_from.resize(m_cost.size());
  for (const auto& [cell, cost] : sources) {
    if (cost >= m_cost[cell]) continue;
    m_cost[cell] = cost;
    m_from[cell] = -1;
    push(cost, cell, m_grid.columnOf(cell));
  }
  return true;
}

const std::vector<CellOrdinal>& ProfileSearch::settleBucket() {
  m_settled.clear();
  while (bucket(m_bucket) < 0) ++m_bucket;
  int& first = bucket(m_bucket);
  while (first >= 0) {  // more may come
    const Front front = m_fronts[static_cast<std::size_t>(first)];
    first = front.next;
    --m_waiting;
    if (front.cost > m_cost[front.cell]) continue;  // it was reached more cheaply before
    m_settled.push_back(front.cell);
    relax(front);
  }
  ++m_bucket;
  return m_settled;
}

inline void ProfileSearch::reach(const Front& before, CellOrdinal cell, int column, double price) {
  double& known = m_cost[cell];
  const double cost = before.cost + (price + m_extra[cell]);
  if (cost > known) return;
  CellOrdinal& from = m_from[cell];
  if (cost < known) {
    known = cost;
    from = before.cell;
    push(cost, cell, column);
  } else if (from >= 0 && std::pair(before.cost, before.cell) < std::pair(m_cost[from], from)) {
    from = before.cell;
  }
}

void ProfileSearch::relax(const Front& front) {
  const int row = front.cell - front.column * m_grid.rows;
  const double along = m_grid.width[front.column] * m_rowFactor[row];
  if (front.column > 0) reach(front, front.cell - m_grid.rows, front.column - 1, along);
  if (front.column + 1 < m_grid.columns) reach(front, front.cell + m_grid.rows, front.column + 1, along);
  if (m_plates[front.column] == 0) return;
  if (row > 0) reach(front, front.cell - 1, front.column, m_grid.rowCost[row]);
  if (row + 1 < m_grid.rows) reach(front, front.cell + 1, front.column, m_grid.rowCost[row]);
}

}  // namespace geargraph
