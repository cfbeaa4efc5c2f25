#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "core/machine/body_layout/profile_router.h"

namespace geargraph {

/// The position of each cell of a grid in a bit set: every column takes a whole number of words, one column
/// after the other.
class ProfileBits {
 public:
  explicit ProfileBits(const ProfileGrid& grid);

  [[nodiscard]] std::size_t perColumn() const { return m_perColumn; }  ///< words
  [[nodiscard]] std::size_t words() const { return m_words; }
  [[nodiscard]] std::size_t wordOf(CellOrdinal cell) const { return m_places[cell].word; }
  [[nodiscard]] int placeOf(CellOrdinal cell) const { return m_places[cell].bit; }
  [[nodiscard]] std::uint64_t bitOf(CellOrdinal cell) const { return std::uint64_t{1} << placeOf(cell); }

 private:
  struct Place {
    std::uint32_t word = 0;
    int bit = 0;
  };
  std::size_t m_perColumn;
  std::size_t m_words;
  ByCell<Place> m_places;
};

/// The owners of the cells of a grid during routing.
class ProfileOwners {
 public:
  /// `bits` outlives it.
  ProfileOwners(const ProfileGrid& grid, const ProfileBits& bits);

  [[nodiscard]] NetOrdinal of(CellOrdinal cell) const { return m_owner[cell]; }
  [[nodiscard]] bool isOpen(CellOrdinal cell, NetOrdinal net) const {
    return of(cell) == ProfileGrid::kFree || of(cell) == net;
  }
  /// Are all cells of the run free? Cost: O(words).
  [[nodiscard]] bool isFree(const ProfileRun& run) const;
  void give(CellOrdinal cell, NetOrdinal net) { set(cell, net); }
  void block(const ProfileRun& run) {
    for (CellOrdinal cell = run.first; cell < run.end; ++cell) set(cell, ProfileGrid::kBlocked);
  }

  [[nodiscard]] const ProfileBits& bits() const { return *m_bits; }
  [[nodiscard]] const std::vector<std::uint64_t>& freeBits() const { return m_free; }
  /// The initial cost of each cell for a search: kFar for a free cell, kShut for any other.
  [[nodiscard]] const ByCell<double>& costs() const { return m_costs; }

  static constexpr double kFar = 1e300;
  static constexpr double kShut = -1;

 private:
  void set(CellOrdinal cell, int owner);

  const ProfileBits* m_bits;
  ByCell<NetOrdinal> m_owner;
  std::vector<std::uint64_t> m_free;
  ByCell<double> m_costs;
};

/// The cheapest paths of a net from source cells of a grid to ends, searched only as far as requested. A step
/// along the axis costs the column's width times a factor of the row; a step across it costs the row's cost
/// and needs a column that is wide enough for a disc. Either adds the extra cost of the cell that it leads
/// to.
///
/// Cells are settled in the order of their rank (A*): the cost of the path to the cell plus a lower bound of
/// the remaining cost. They are settled bucket by bucket: a bucket has the cells whose ranks are
/// within the cost of one step, so no heap is needed. Of paths with equal cost the one over the cheaper cell,
/// then over the cell with the smaller number is kept: paths do not depend on the order of settling.
///
/// Cost: O(cells) per search, some ten nanoseconds per cell.
/// @pre widths and row costs are positive
class ProfileSearch {
 public:
  /// Cells, and the cost of beginning or ending there.
  using Places = std::vector<std::pair<CellOrdinal, double>>;

  explicit ProfileSearch(const ProfileGrid& grid);

  /// Begins a new search over free cells and those in `own`. `extra`: additional costs of the cells, valid
  /// until the next call. False if no path leads from a source to an end.
  /// @pre there are ends; an extra cost for every cell, none below 0
  [[nodiscard]] bool begin(const ProfileOwners& owners,
                           std::initializer_list<std::span<const CellOrdinal>> own,
                           OrdinalSpan<CellTag, const double> extra, const Places& sources,
                           const Places& ends);
  /// Are all reachable cells settled?
  [[nodiscard]] bool isDone() const { return m_waiting == 0; }
  /// Are all cells settled that are on a path of at most this cost, its end included? (And one bucket more,
  /// because ranks along a path may decrease by rounding.)
  [[nodiscard]] bool isBeyond(double cost) const { return bucketOf(cost) + 1 < m_bucket; }
  /// Settles the next bucket and returns its cells, valid until the next call; a cell may occur twice.
  /// @pre !isDone()
  [[nodiscard]] const std::vector<CellOrdinal>& settleBucket();

  [[nodiscard]] double cost(CellOrdinal cell) const { return m_cost[cell]; }
  /// The previous cell on the path; -1: the path begins here.
  [[nodiscard]] CellOrdinal from(CellOrdinal cell) const { return m_from[cell]; }

 private:
  /// A reached cell, and the cost of the path to it.
  struct Front {
    double cost = 0;
    CellOrdinal cell = 0;
    int column = 0;
    int next = -1;  ///< next of the same bucket: position in m_fronts; -1: none
  };
  [[nodiscard]] long bucketOf(double cost) const { return static_cast<long>(cost * m_perStep); }
  [[nodiscard]] int& bucket(long number) {
    return m_buckets[static_cast<std::size_t>(number) & (m_buckets.size() - 1)];
  }
  [[nodiscard]] bool isJoined(const ProfileBits& bits, const Places& sources, const Places& ends);
  void fill(std::size_t column);
  bool spread(std::size_t column);
  void lookAhead(const Places& ends);
  void makeBuckets(const Places& sources);
  void push(double cost, CellOrdinal cell, int column) {
    const double rank = cost + (m_columnAhead[column] + m_rowAhead[cell - column * m_grid.rows]);
    int& first = bucket(std::max(bucketOf(rank), m_bucket));
    m_fronts.push_back({cost, cell, column, first});
    first = static_cast<int>(m_fronts.size()) - 1;
    ++m_waiting;
  }
  void relax(const Front& front);
  void reach(const Front& before, CellOrdinal cell, int column, double price);

  const ProfileGrid& m_grid;
  double m_cheapest = 1;  ///< cost of a step
  double m_widest = 0;
  double m_perStep = 1;            ///< buckets for a cost of 1
  ByRow<double> m_rowFactor;       ///< of the width, for a step along the axis
  ByColumn<double> m_columnAhead;  ///< lower bound of the cost along the axis to an end
  ByRow<double> m_rowAhead;        ///< the same for the cost across
  ByCell<double> m_cost;           ///< so far; below 0: not open
  ByCell<CellOrdinal> m_from;
  ByColumn<char> m_plates;
  OrdinalSpan<CellTag, const double> m_extra;
  std::vector<Front> m_fronts;  ///< of the whole search
  std::vector<int> m_buckets;   ///< the last front of each, -1: none; as many as the most expensive step
                                ///< spans, in a ring; a power of two
  std::vector<CellOrdinal> m_settled;
  std::size_t m_perColumn = 0;          ///< words
  std::vector<std::uint64_t> m_open;    ///< by column and word: cells that are open
  std::vector<std::uint64_t> m_joined;  ///< of these: connected to a source
  std::vector<char> m_isSpread;         ///< by column: nothing was joined since it was processed
  std::size_t m_waiting = 0;            ///< fronts in all buckets
  long m_bucket = 0;                    ///< the next bucket
};

}  // namespace geargraph
