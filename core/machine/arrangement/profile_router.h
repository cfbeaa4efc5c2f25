#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace geargraph::inline arrangement {

/// Cells of one column, next to each other.
struct ProfileRun {
  int first = 0;
  int end = 0;  ///< one past the last

  [[nodiscard]] bool contains(int cell) const { return first <= cell && cell < end; }
  friend bool operator==(const ProfileRun&, const ProfileRun&) = default;
};

/// The half plane through an axis, divided into cells: columns along the axis, rows away from it. A part that
/// turns about the axis always covers the same cells, so links that share no cell never collide.
struct ProfileGrid {
  static constexpr int kFree = -1;
  static constexpr int kBlocked = -2;

  int columns = 0;
  int rows = 0;
  std::vector<int> owner;       ///< by cell: kFree, kBlocked, or the net whose wheel is there
  std::vector<bool> plates;     ///< by column: is it wide enough for a disc?
  std::vector<double> width;    ///< by column: the cost of a step along the axis
  std::vector<double> rowCost;  ///< by row: the cost of a step away from the axis

  [[nodiscard]] int cell(int column, int row) const { return column * rows + row; }
  /// The cells of a column from a row outwards.
  [[nodiscard]] ProfileRun above(int column, int row) const {
    return {cell(column, row), cell(column, rows)};
  }
  [[nodiscard]] int columnOf(int cell) const { return cell / rows; }
  [[nodiscard]] int rowOf(int cell) const { return cell % rows; }
  friend bool operator==(const ProfileGrid&, const ProfileGrid&) = default;
};

/// A terminal of a net: `cells` become the net's, `keptFree` is reserved and stays empty.
struct RouteTerminal {
  std::vector<int> cells;
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
  std::vector<int> cells;     ///< including those of its terminals
  std::vector<int> terminal;  ///< by group: the terminal taken
  int support = -1;
};

constexpr int kMostRouteRounds = 40;
/// The largest cells * nets that is routed: some 100 MB, and 0.1 s per round.
constexpr std::size_t kMostRoutedCells = 4'000'000;

/// Routes for all nets that share no cell: one net after the other by its cheapest path, which avoids the
/// terminals of other nets unless that is expensive. A net without a path is routed first in the next round,
/// and the cells that blocked it become more expensive for all others (after L. McMurchie and C. Ebeling,
/// PathFinder, FPGA 1995, where nets may overlap meanwhile). Deterministic, and similar nets get similar
/// routes. std::nullopt after `tries` rounds, if a net has no path even by itself, if nets * cells exceeds
/// kMostRoutedCells, or if `stop` was requested meanwhile. Cost: O(nets * cells) per round.
[[nodiscard]] std::optional<std::vector<ProfileRoute>> routeProfiles(const ProfileGrid& grid,
                                                                     const std::vector<ProfileNet>& nets,
                                                                     int tries = kMostRouteRounds,
                                                                     const std::stop_token& stop = {});

}  // namespace geargraph::inline arrangement
