#pragma once

#include <compare>
#include <stop_token>

#include "core/presentation/schematic/arm_grid.h"

namespace geargraph {

/// Searches a grid for the cheapest path of an arm from start nodes to a target node.
///
/// A state is a node and the direction in which it was reached: 2 * node if horizontal, 2 * node + 1 if
/// vertical. Costs are relaxed along the lanes in both directions until nothing changes: without a queue, in
/// at most as many rounds as the path has bends, with the same result as any shortest-path search.
class ArmSearch {
 public:
  /// Begins a new search, reusing the memory. Both arguments outlive the search.
  void begin(const ArmGrid& grid, const ArmEdgeWeights& weights);

  /// Adds a start node with its cost.
  void addStart(std::size_t node, double penalty);
  /// Adds a target node with its cost. Of several at one node the cheapest counts, then the first.
  void addTarget(std::size_t node, double price, std::size_t number);

  struct Way {
    std::vector<std::size_t> nodes;  ///< from the start to the target
    std::size_t target = 0;          ///< its number
  };
  /// std::nullopt if there is none, or `stop` was requested meanwhile.
  [[nodiscard]] std::optional<Way> cheapest(const std::stop_token& stop = {});

 private:
  static constexpr double kFar = 1e300;  ///< absorbs any addition: kFar + x == kFar
  struct Target {
    std::size_t node = 0;
    double price = 0;
    std::size_t number = 0;
  };
  /// Per row: the pending relaxations.
  struct Pending {
    bool level = false;  ///< along the row
    bool down = false;
    bool up = false;
  };

  /// A possible end; smaller is preferred.
  struct End {
    double cost = 0;
    std::size_t rank = 0;
    double before = 0;  ///< cost without the target's price
    std::size_t state = 0;
    std::size_t target = 0;
    friend auto operator<=>(const End&, const End&) = default;
  };

  void lookAhead();
  void narrow();
  void goLevel();
  void goAcross();
  [[nodiscard]] std::optional<End> cheapestEnd() const;
  void alongRows(const std::size_t* rows, std::size_t count);
  void acrossRows(std::size_t from, std::size_t to, double length, const double* weights,
                  bool Pending::*onward);
  [[nodiscard]] double costOf(std::size_t state) const {
    return (state % 2 == 0 ? m_level : m_upright)[state / 2];
  }
  [[nodiscard]] std::optional<std::size_t> before(std::size_t state) const;

  const ArmGrid* m_grid = nullptr;
  const ArmEdgeWeights* m_weights = nullptr;
  std::vector<double> m_level;    ///< by node: cost of the cheapest path that reaches it horizontally
  std::vector<double> m_upright;  ///< and vertically
  std::vector<double> m_start;    ///< by node
  std::vector<Target> m_targets;
  std::vector<double> m_columnAhead;  ///< by column: lower bound of the remaining cost
  std::vector<double> m_rowAhead;     ///< and by row
  std::vector<Pending> m_pending;     ///< by row
  std::vector<std::size_t> m_rows;    ///< for goLevel()
  double m_most = kFar;               ///< paths above this cost are pruned
};

}  // namespace geargraph
