#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "core/machine/arrangement/meridian_router.h"

namespace geargraph::inline arrangement {

/// Where the cells of a grid are as bits: a column's rows fill so many words, the next column's the next
/// ones.
class MeridianBits {
 public:
  explicit MeridianBits(const MeridianGrid& grid);

  [[nodiscard]] std::size_t perColumn() const { return m_perColumn; }  ///< words
  [[nodiscard]] std::size_t words() const { return m_words; }
  [[nodiscard]] std::size_t wordOf(int cell) const { return m_places[static_cast<std::size_t>(cell)].word; }
  [[nodiscard]] int placeOf(int cell) const { return m_places[static_cast<std::size_t>(cell)].bit; }
  [[nodiscard]] std::uint64_t bitOf(int cell) const { return std::uint64_t{1} << placeOf(cell); }

 private:
  struct Place {
    std::uint32_t word = 0;
    int bit = 0;
  };
  std::size_t m_perColumn;
  std::size_t m_words;
  std::vector<Place> m_places;  ///< by cell
};

/// Who owns the cells of a grid while its nets are laid.
class MeridianOwners {
 public:
  /// `bits` outlives it.
  MeridianOwners(const MeridianGrid& grid, const MeridianBits& bits);

  [[nodiscard]] int of(int cell) const { return m_owner[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] bool isOpen(int cell, int net) const {
    return of(cell) == MeridianGrid::kFree || of(cell) == net;
  }
  /// Are all cells of the run free? Cost: O(words).
  [[nodiscard]] bool isFree(const MeridianRun& run) const;
  void give(int cell, int net) { set(cell, net); }
  void block(const MeridianRun& run) {
    for (int cell = run.first; cell < run.end; ++cell) set(cell, MeridianGrid::kBlocked);
  }

  [[nodiscard]] const MeridianBits& bits() const { return *m_bits; }
  [[nodiscard]] const std::vector<std::uint64_t>& freeBits() const { return m_free; }
  /// What a search knows of a cell before it begins: kFar of a free one, kShut of any other.
  [[nodiscard]] const std::vector<double>& costs() const { return m_costs; }

  static constexpr double kFar = 1e300;
  static constexpr double kShut = -1;

 private:
  void set(int cell, int owner);

  const MeridianBits* m_bits;
  std::vector<int> m_owner;
  std::vector<std::uint64_t> m_free;
  std::vector<double> m_costs;
};

/// The cheapest ways of a net from some cells of a grid to others, found only as far as they are asked for. A
/// step along the axis costs the column's width, dearer by the row; one across it the row's cost, and needs a
/// column that is wide enough for a disc. Either costs in addition what the cell does that it leads to.
///
/// Cells from which an end may be near are settled first (A*): a cell's rank is what the way to it costs and
/// what the rest costs at least. They are settled lot by lot: a lot are the cells whose ranks lie within one
/// step's cost, so that no heap has to order them. Of ways that cost the same the one stands that comes over
/// the cheaper cell, then over the one with the smaller number: ways do not depend on the order of settling.
///
/// Cost: O(cells) a search, some ten nanoseconds each.
/// @pre widths and row costs are positive
class MeridianSearch {
 public:
  using Places = std::vector<std::pair<int, double>>;  ///< cells, and what it costs to begin or end there

  explicit MeridianSearch(const MeridianGrid& grid);

  /// A new search over free cells and those in `own`. `extra`: what cells cost in addition, until the next
  /// call. False where no way at all leads from a source to an end.
  /// @pre there are ends; an extra cost for every cell, none below 0
  [[nodiscard]] bool begin(const MeridianOwners& owners, std::initializer_list<std::span<const int>> own,
                           std::span<const double> extra, const Places& sources, const Places& ends);
  /// Is every cell settled that can be reached?
  [[nodiscard]] bool isDone() const { return m_waiting == 0; }
  /// Is every cell settled that lies on a way that costs no more, its end included? One lot more is, too: the
  /// ranks along a way may fall by a rounding.
  [[nodiscard]] bool isBeyond(double cost) const { return lotOf(cost) + 1 < m_lot; }
  /// Settles the next lot. Valid until the next call; a cell may be in it twice.
  /// @pre !isDone()
  [[nodiscard]] const std::vector<int>& settleLot();

  [[nodiscard]] double cost(int cell) const { return m_cost[static_cast<std::size_t>(cell)]; }
  /// The cell before on the way; -1: the way begins here.
  [[nodiscard]] int from(int cell) const { return m_from[static_cast<std::size_t>(cell)]; }

 private:
  /// A cell that was reached, and what the way to it costs.
  struct Front {
    double cost = 0;
    int cell = 0;
    int column = 0;
    int next = -1;  ///< of the same lot: position in m_fronts
  };
  [[nodiscard]] long lotOf(double cost) const { return static_cast<long>(cost * m_perStep); }
  [[nodiscard]] int& lot(long number) {
    return m_lots[static_cast<std::size_t>(number) & (m_lots.size() - 1)];
  }
  [[nodiscard]] bool isJoined(const MeridianBits& bits, const Places& sources, const Places& ends);
  void fill(std::size_t column);
  bool spread(std::size_t column);
  void lookAhead(const Places& ends);
  void makeLots(const Places& sources);
  void push(double cost, int cell, int column) {
    const double rank = cost + (m_columnAhead[static_cast<std::size_t>(column)] +
                                m_rowAhead[static_cast<std::size_t>(cell - column * m_grid.rows)]);
    int& first = lot(std::max(lotOf(rank), m_lot));
    m_fronts.push_back({cost, cell, column, first});
    first = static_cast<int>(m_fronts.size()) - 1;
    ++m_waiting;
  }
  void relax(const Front& front);
  void reach(const Front& before, int cell, int column, double price);

  const MeridianGrid& m_grid;
  double m_cheapest = 1;  ///< step
  double m_widest = 0;
  double m_perStep = 1;               ///< lots for a cost of 1
  std::vector<double> m_rowFactor;    ///< of the width, for a step along the axis
  std::vector<double> m_columnAhead;  ///< by column: what the way along the axis to an end costs at least
  std::vector<double> m_rowAhead;     ///< by row: the same of the way across
  std::vector<double> m_cost;         ///< by cell, as far as the search has come; below 0: not open
  std::vector<int> m_from;            ///< by cell
  std::vector<char> m_plates;         ///< by column
  std::span<const double> m_extra;    ///< by cell
  std::vector<Front> m_fronts;        ///< all of the search
  std::vector<int> m_lots;  ///< the last front of each, -1: none; as many as the dearest step spans,
                            ///< in a ring; a power of two
  std::vector<int> m_settled;
  std::size_t m_perColumn = 0;          ///< words
  std::vector<std::uint64_t> m_open;    ///< by column and word: cells that are open
  std::vector<std::uint64_t> m_joined;  ///< of these: found to hang together with a source
  std::vector<char> m_isSpread;         ///< by column: nothing was joined since it was looked at
  std::size_t m_waiting = 0;            ///< fronts in all lots
  long m_lot = 0;                       ///< the next
};

}  // namespace geargraph::inline arrangement
