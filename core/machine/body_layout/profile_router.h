#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/base/ordinal.h"

namespace geargraph {

using CellOrdinal = Ordinal<struct CellTag>;  ///< of a cell of a profile grid
using NetOrdinal = Ordinal<struct NetTag>;    ///< of a net that is routed in it
template <class T>
using ByCell = OrdinalVector<CellTag, T>;
template <class T>
using ByNet = OrdinalVector<NetTag, T>;
template <class T>
using ByColumn = OrdinalVector<struct ColumnTag, T>;
template <class T>
using ByRow = OrdinalVector<struct RowTag, T>;

/// Cells of one column, next to each other.
struct ProfileRun {
  int first = 0;
  int end = 0;  ///< one past the last

  [[nodiscard]] bool contains(CellOrdinal cell) const { return first <= cell && cell < end; }
  friend bool operator==(const ProfileRun&, const ProfileRun&) = default;
};

/// The half plane through an axis, divided into cells: columns along the axis, rows away from it. A part that
/// turns about the axis always covers the same cells, so links that share no cell never collide.
struct ProfileGrid {
  static constexpr int kFree = -1;
  static constexpr int kBlocked = -2;

  int columns = 0;
  int rows = 0;
  ByCell<NetOrdinal> owner;  ///< kFree, kBlocked, or the net whose wheel is there
  ByColumn<bool> plates;     ///< is it wide enough for a disc?
  ByColumn<double> width;    ///< the cost of a step along the axis
  ByRow<double> rowCost;     ///< the cost of a step away from the axis

  [[nodiscard]] CellOrdinal cell(int column, int row) const { return column * rows + row; }
  /// The cells of a column from a row outwards.
  [[nodiscard]] ProfileRun above(int column, int row) const {
    return {cell(column, row), cell(column, rows)};
  }
  [[nodiscard]] int columnOf(CellOrdinal cell) const { return cell / rows; }
  [[nodiscard]] int rowOf(CellOrdinal cell) const { return cell % rows; }
  friend bool operator==(const ProfileGrid&, const ProfileGrid&) = default;
};

/// A terminal of a net: `cells` become the net's, `keptFree` is reserved and stays empty.
struct RouteTerminal {
  std::vector<CellOrdinal> cells;
  ProfileRun keptFree;
  double cost = 0;
  friend bool operator==(const RouteTerminal&, const RouteTerminal&) = default;
};

/// What one link has to connect on the axis.
struct ProfileNet {
  std::vector<std::vector<RouteTerminal>> groups;  ///< one terminal of each group has to be reached
  std::vector<RouteTerminal> supports;             ///< one of them is reached if possible
  bool needsSupport = false;                       ///< a support has to be reached
  friend bool operator==(const ProfileNet&, const ProfileNet&) = default;
};

/// The route of one net.
struct ProfileRoute {
  std::vector<CellOrdinal> cells;  ///< including those of its terminals
  std::vector<int> terminal;       ///< by group: the terminal taken
  int support = -1;
};

constexpr int kMaxRouteRounds = 40;
/// The largest cells * nets that is routed: some 100 MB, and 0.1 s per round.
constexpr std::size_t kMaxRoutedCells = 4'000'000;

/// Routes for all nets that share no cell: one net after the other by its cheapest path, which avoids the
/// terminals of other nets unless that is expensive. A net without a path is routed first in the next round,
/// and the cells that blocked it become more expensive for all others (after L. McMurchie and C. Ebeling,
/// PathFinder, FPGA 1995, where nets may overlap meanwhile). Deterministic, and similar nets get similar
/// routes. std::nullopt after `tries` rounds, if a net has no path even by itself, if nets * cells exceeds
/// kMaxRoutedCells, or if `stop` was requested meanwhile. Cost: O(nets * cells) per round.
[[nodiscard]] std::optional<ByNet<ProfileRoute>> routeProfiles(const ProfileGrid& grid,
                                                               const ByNet<ProfileNet>& nets,
                                                               int tries = kMaxRouteRounds,
                                                               const std::stop_token& stop = {});

}  // namespace geargraph
