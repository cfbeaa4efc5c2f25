#pragma once

#include <optional>
#include <vector>

#include "core/schematic/shaft_plan.h"

namespace geargraph {

/// Chooses places for bearings and shafts so that as little as possible of different links crosses: a bearing
/// or a ring's wall stands left or right of wheels, near where the document has it; the frame comes from
/// outside; shafts on one axis are nested, so that what comes from farther in passes inside. Local search
/// over all of them; deterministic. Cost of search(): O(rounds * things * places * things).
class Stacker {
 public:
  Stacker(const DrawnPart& part, const Placement& placement, SheetLayout& layout);

  void search();
  /// Moves everything together along the axes. @pre the layout is parallel
  void squeeze();
  [[nodiscard]] ShaftPlan plan() const;

  // For those who know more about a bearing's place.
  [[nodiscard]] std::vector<double> placesOf(int joint) const;
  [[nodiscard]] double placeOf(int joint) const { return m_bearings[static_cast<std::size_t>(joint)].at; }
  void move(int joint, double to) { m_bearings[static_cast<std::size_t>(joint)].at = to; }
  [[nodiscard]] double costOf(int joint) const { return cost(itemOf(joint)); }

 private:
  /// A bearing or a cup.
  struct Item {
    bool isCup = false;
    int index = 0;
    double wanted = 0;
    double insistence = 0;  ///< cost of a px away from there
    std::vector<double> places;
  };
  struct Piece {
    Extent box;
    int owner = 0;  ///< a link; below 0: a bearing's symbol, -1 - joint
  };
  /// Where something of a link stands up from an axis.
  struct Column {
    double at = 0;
    int link = 0;
    bool closes = false;  ///< moves, and so keeps the frame from what lies behind it
  };
  struct Range {
    double low = 1e300;
    double high = -1e300;
    void include(double from, double to) {
      low = std::min(low, from);
      high = std::max(high, to);
    }
    [[nodiscard]] bool isEmpty() const { return low > high; }
  };

  void addBearings();
  void addCups();
  void addFixedPieces();
  [[nodiscard]] std::vector<double> placesOn(int axis, double wanted) const;
  [[nodiscard]] bool areParallel(int a, int b) const;
  [[nodiscard]] double& atOf(const Item& item);
  [[nodiscard]] double atOf(const Item& item) const;
  [[nodiscard]] int axisOf(const Item& item) const;
  [[nodiscard]] std::vector<double> candidatesOf(const Item& item) const;
  [[nodiscard]] std::vector<Piece> piecesOf(const Item& item) const;
  [[nodiscard]] double cost(std::size_t item) const;
  [[nodiscard]] std::size_t itemOf(int joint) const;
  [[nodiscard]] double enclosure(const SheetBearing& bearing) const;
  [[nodiscard]] double compactness(const Item& item) const;
  [[nodiscard]] std::vector<int> linksOn(int axis) const;
  [[nodiscard]] bool reachesAcross(int link) const;
  [[nodiscard]] std::vector<Column> columnsOn(int axis) const;
  [[nodiscard]] Range rangeOf(int axis, int link) const;
  [[nodiscard]] double freeEndOf(const SheetBearing& bearing) const;
  [[nodiscard]] int conflictsOn(int axis) const;
  [[nodiscard]] std::vector<std::pair<int, Range>> tubesTouchedBy(const Item& item) const;
  [[nodiscard]] Extent boxOn(int axis, double low, double high, double from, double to) const;
  void addShafts(ShaftPlan& plan, int axis) const;

  const DrawnPart& m_part;
  const Placement& m_placement;
  SheetLayout& m_layout;
  std::vector<SheetBearing> m_bearings;
  std::vector<SheetCup> m_cups;
  std::vector<Item> m_items;
  std::vector<Piece> m_fixed;
};

}  // namespace geargraph
