#pragma once

#include <compare>
#include <stop_token>

#include "core/presentation/schematic/arm_grid.h"

namespace geargraph::inline schematic {

/// Searches a grid for the cheapest way of an arm from some of its nodes to one of others.
///
/// A state is a node and how it was reached: 2 * node if level, 2 * node + 1 if upright. What a state costs
/// goes along the lanes, to and fro, until nothing gets cheaper: that needs no queue, no more rounds than the
/// courses have bends, and comes to the same numbers as every other search.
class ArmSearch {
 public:
  /// Forgets everything but what memory it has. Both have to live as long as it is asked.
  void begin(const ArmGrid& grid, const ArmTolls& tolls);

  /// It costs so much to begin at a node.
  void addStart(std::size_t node, double hold);
  /// It costs so much to end at a node. Of several at one node the cheapest counts, then the first.
  void addTarget(std::size_t node, double price, std::size_t number);

  struct Way {
    std::vector<std::size_t> nodes;  ///< from the start to the target
    std::size_t target = 0;          ///< its number
  };
  /// std::nullopt if there is none, or `stop` was requested meanwhile.
  [[nodiscard]] std::optional<Way> cheapest(const std::stop_token& stop = {});

 private:
  static constexpr double kFar = 1e300;  ///< what comes to it is still that, and from itself it is 0 away
  struct Target {
    std::size_t node = 0;
    double price = 0;
    std::size_t number = 0;
  };
  /// Of a row: what has to go on from there.
  struct Pending {
    bool level = false;  ///< along the row
    bool down = false;
    bool up = false;
  };

  /// In the order in which ends are preferred.
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
  void acrossRows(std::size_t from, std::size_t to, double length, const double* tolls,
                  bool Pending::*onward);
  [[nodiscard]] double costOf(std::size_t state) const {
    return (state % 2 == 0 ? m_level : m_upright)[state / 2];
  }
  [[nodiscard]] std::optional<std::size_t> before(std::size_t state) const;

  const ArmGrid* m_grid = nullptr;
  const ArmTolls* m_tolls = nullptr;
  std::vector<double> m_level;    ///< by node: cost of the ways that reach it level
  std::vector<double> m_upright;  ///< and upright
  std::vector<double> m_start;    ///< by node
  std::vector<Target> m_targets;
  std::vector<double> m_columnAhead;  ///< by column: the least that is left to pay from there
  std::vector<double> m_rowAhead;     ///< and by row
  std::vector<Pending> m_pending;     ///< by row
  std::vector<std::size_t> m_rows;    ///< for goLevel()
  double m_most = kFar;               ///< what costs more leads nowhere
};

}  // namespace geargraph::inline schematic
