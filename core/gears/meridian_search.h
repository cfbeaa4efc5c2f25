#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/gears/meridian_router.h"

namespace geargraph {

/// The cheapest ways of a net from some cells of a grid to others, found only as far as they are asked for. A
/// step along the axis costs the column's width, dearer by the row; one across it the row's cost, and needs a
/// column that is wide enough for a disc.
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

  /// A new search for `net`, whose own cells and free ones `owner` names. `rowExtra`: what rows cost along
  /// the axis in addition, as a share.
  /// @pre there are ends
  void begin(int net, const std::vector<int>& owner, std::span<const double> rowExtra, const Places& sources,
             const Places& ends);
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
  };
  [[nodiscard]] long lotOf(double cost) const { return static_cast<long>(cost * m_perStep); }
  [[nodiscard]] std::vector<Front>& lot(long number) {
    return m_lots[static_cast<std::size_t>(number) & (m_lots.size() - 1)];
  }
  void lookAhead(const Places& ends);
  void makeLots(const Places& sources);
  void push(double cost, int cell, int column) {
    const double rank = cost + (m_columnAhead[static_cast<std::size_t>(column)] +
                                m_rowAhead[static_cast<std::size_t>(cell - column * m_grid.rows)]);
    lot(std::max(lotOf(rank), m_lot)).push_back({cost, cell, column});
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
  std::vector<std::vector<Front>> m_lots;  ///< as many as the dearest step spans, in a ring; a power of two
  std::vector<int> m_settled;
  std::size_t m_waiting = 0;  ///< fronts in all lots
  long m_lot = 0;             ///< the next
};

}  // namespace geargraph
