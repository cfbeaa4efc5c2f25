#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace geargraph::inline arrangement {

/// Cells of one column, next to each other.
struct MeridianRun {
  int first = 0;
  int end = 0;  ///< behind the last

  [[nodiscard]] bool contains(int cell) const { return first <= cell && cell < end; }
  friend bool operator==(const MeridianRun&, const MeridianRun&) = default;
};

/// Half a plane through an axis, cut into cells: columns along the axis, rows away from it. What turns about
/// the axis covers the same cells for ever, so links that share no cell never meet.
struct MeridianGrid {
  static constexpr int kFree = -1;
  static constexpr int kBlocked = -2;

  int columns = 0;
  int rows = 0;
  std::vector<int> owner;       ///< by cell: kFree, kBlocked, or the net whose wheel lies there
  std::vector<bool> plates;     ///< by column: is it wide enough for a disc?
  std::vector<double> width;    ///< by column: what a way along it costs
  std::vector<double> rowCost;  ///< by row: what a step away from the axis costs

  [[nodiscard]] int cell(int column, int row) const { return column * rows + row; }
  /// The column from a row outwards.
  [[nodiscard]] MeridianRun above(int column, int row) const {
    return {cell(column, row), cell(column, rows)};
  }
  [[nodiscard]] int columnOf(int cell) const { return cell / rows; }
  [[nodiscard]] int rowOf(int cell) const { return cell % rows; }
  friend bool operator==(const MeridianGrid&, const MeridianGrid&) = default;
};

/// One way for a net to end somewhere: all of its cells become the net's, those kept free nobody's.
struct MeridianLanding {
  std::vector<int> cells;
  MeridianRun keptFree;
  double cost = 0;
  friend bool operator==(const MeridianLanding&, const MeridianLanding&) = default;
};

/// What one link has to join on the axis.
struct MeridianNet {
  std::vector<std::vector<MeridianLanding>> groups;  ///< one landing of each has to be reached
  std::vector<MeridianLanding> supports;             ///< one of them, where it can be
  bool needsSupport = false;                         ///< it must be
  friend bool operator==(const MeridianNet&, const MeridianNet&) = default;
};

struct MeridianRoute {
  std::vector<int> cells;    ///< those of the landings included
  std::vector<int> landing;  ///< by group: which one
  int support = -1;
};

constexpr int kMostRouteRounds = 40;
/// Cells times nets that are routed: some 100 MB, and 0.1 s a round.
constexpr std::size_t kMostRoutedCells = 4'000'000;

/// Ways for all nets that share no cell: nets one after the other by their cheapest ways, which keep clear of
/// where others can land if that is not dear. A net that finds none goes first in the next round, and what
/// stood in its way gets dearer for all others (after L. McMurchie and C. Ebeling, PathFinder, FPGA 1995;
/// there nets overlap meanwhile). Deterministic, and nets much alike get ways much alike. Nothing after
/// `tries` rounds, where a net finds no way even by itself, where nets * cells is over kMostRoutedCells, or
/// when `stop` was requested meanwhile. Cost: O(nets * cells) a round.
[[nodiscard]] std::optional<std::vector<MeridianRoute>> routeMeridian(const MeridianGrid& grid,
                                                                      const std::vector<MeridianNet>& nets,
                                                                      int tries = kMostRouteRounds,
                                                                      const std::stop_token& stop = {});

}  // namespace geargraph::inline arrangement
