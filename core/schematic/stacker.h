#pragma once

#include <optional>
#include <stop_token>
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

  /// Gives up early when `stop` is requested.
  void search(const std::stop_token& stop = {});
  /// Moves everything together along the axes. @pre the layout is parallel
  void squeeze();
  [[nodiscard]] ShaftPlan plan() const;

  // For those who know more about a bearing's place.
  [[nodiscard]] std::vector<double> placesOf(int joint) const;
  [[nodiscard]] double placeOf(int joint) const { return m_bearings[static_cast<std::size_t>(joint)].at; }
  void move(int joint, double to) { m_bearings[static_cast<std::size_t>(joint)].at = to; }
  [[nodiscard]] double costOf(int joint) const;

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
  /// All that an item can get in the way of.
  struct Scene {
    struct Tube {
      Extent box;
      int link = 0;
      int axis = 0;
    };
    std::vector<Piece> pieces;
    std::vector<int> axisOf;  ///< by piece: where it stands; -1 for wheels
    std::vector<Tube> tubes;
  };
  [[nodiscard]] Scene sceneWithout(std::size_t item) const;
  [[nodiscard]] double cost(const Item& item, const Scene& scene, double tooMuch) const;
  void indexByAxis();
  [[nodiscard]] std::size_t itemOf(int joint) const;
  [[nodiscard]] double enclosure(const SheetBearing& bearing) const;
  [[nodiscard]] double compactness(const Item& item, const std::vector<std::pair<int, Range>>& tubes) const;
  [[nodiscard]] const std::vector<int>& linksOn(int axis) const {
    return m_on[static_cast<std::size_t>(axis)].links;
  }
  /// Without a list of them: they are asked for at every place that is tried.
  template <class Visit>
  void forColumns(int axis, const Visit& visit) const;
  [[nodiscard]] std::vector<Column> columnsOn(int axis) const;
  [[nodiscard]] Range rangeOf(int axis, int link) const;
  [[nodiscard]] double freeEndOf(const SheetBearing& bearing) const;
  /// What a link has on an axis, for all links at once.
  struct OnShaft {
    int link = 0;
    Range range;
    std::vector<double> columns;  ///< ascending
  };
  [[nodiscard]] std::vector<OnShaft> shaftsOn(int axis) const;
  [[nodiscard]] bool isOwn(int axis, int link) const;
  [[nodiscard]] std::vector<int> movedBy(const Item& item) const;
  [[nodiscard]] int conflictsOn(int axis, const std::vector<int>& moved) const;
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

  /// What stands on an axis, by position.
  struct OnAxis {
    std::vector<int> wheels;
    std::vector<int> cups;
    std::vector<int> bearings;
    std::vector<int> arms;   ///< bearings elsewhere that straight arms from here hold
    std::vector<int> links;  ///< that have a shaft or a wheel here, ascending
  };
  std::vector<OnAxis> m_on;
  /// By link: does it hold axes that are not parallel to its own? Its arms go round what is between.
  std::vector<bool> m_reachesAcross;
};

}  // namespace geargraph
