#pragma once

#include <array>
#include <stop_token>
#include <vector>

#include "core/presentation/schematic/shaft_plan.h"

namespace geargraph::inline schematic {

/// Chooses places for bearings and shafts so that as little as possible of different links crosses: a bearing
/// or a ring's wall stands left or right of wheels, near where the document has it; the frame comes from
/// outside; shafts on one axis are nested, so that what comes from farther in passes inside. Local search
/// over all of them; deterministic. Cost of search(): O(rounds * things * places * things).
class Stacker {
 public:
  /// Bearings that the document has far beyond everything else are drawn at the edge of the sheet.
  Stacker(const DrawnPart& part, const Placement& placement, SheetLayout& layout);

  /// Gives up early when `stop` is requested.
  void search(const std::stop_token& stop = {});
  /// Moves everything together along the axes. @pre the layout is parallel
  void squeeze();
  [[nodiscard]] ShaftPlan plan() const;

  // For those who know more about a bearing's place.
  [[nodiscard]] std::vector<double> placesOf(int joint) const;
  [[nodiscard]] double placeOf(int joint) const { return m_bearings[static_cast<std::size_t>(joint)].at; }
  void move(int joint, double to) { put(m_items[itemOf(joint)], to); }
  [[nodiscard]] double costOf(int joint) const;

 private:
  /// A bearing or a cup.
  struct Item {
    bool isCup = false;
    int index = 0;
    double wanted = 0;
    double insistence = 0;  ///< cost of a px away from there
    std::vector<double> places;
    std::size_t column = 0;  ///< its place among those on its axis
    std::size_t arm = 0;     ///< that of its straight arm on the parent's axis
  };
  /// One or two: they are asked for at every place that is tried.
  template <class Value>
  class Few {
   public:
    Few(const Value& first) : m_values{first} {}
    Few(const Value& first, const Value& second) : m_values{first, second}, m_count(2) {}
    void add(const Value& second) { m_values[m_count++] = second; }
    [[nodiscard]] const Value* begin() const { return m_values.data(); }
    [[nodiscard]] const Value* end() const { return m_values.data() + m_count; }

   private:
    std::array<Value, 2> m_values;
    std::size_t m_count = 1;
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
    int shaft = -1;       ///< place of the link among those on the axis; -1: it has none there
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
  /// The shaft of a link on an axis.
  struct Tube {
    int axis = 0;
    int link = 0;
    Range range;
  };

  /// What stands on an axis, by position.
  struct OnAxis {
    std::vector<int> wheels;
    std::vector<int> cups;
    std::vector<int> bearings;
    std::vector<int> arms;        ///< bearings elsewhere that straight arms from here hold
    std::vector<int> links;       ///< that have a shaft or a wheel here, ascending
    std::vector<Column> columns;  ///< of wheels, cups, bearings and arms, in this order
  };

  void addBearings();
  void addCups();
  void addFixedPieces();
  [[nodiscard]] Range drawnOn(int axis) const;
  [[nodiscard]] std::vector<double> placesOn(int axis, double wanted) const;
  [[nodiscard]] bool areParallel(int a, int b) const;
  [[nodiscard]] double atOf(const Item& item) const;
  void put(const Item& item, double to);
  [[nodiscard]] int axisOf(const Item& item) const;
  [[nodiscard]] std::vector<double> candidatesOf(const Item& item) const;
  [[nodiscard]] Few<Piece> piecesOf(const Item& item) const;
  /// All that an item can get in the way of.
  struct Scene {
    struct Standing {
      Piece piece;
      int axis = 0;
    };
    struct Shaft {
      Extent box;
      int link = 0;
      int axis = 0;
    };
    std::vector<Piece> pieces;       ///< wheels, and what stands on axes
    std::vector<Standing> standing;  ///< the latter
    std::vector<Shaft> shafts;
  };
  [[nodiscard]] Scene sceneWithout(std::size_t item) const;
  [[nodiscard]] double cost(const Item& item, const Scene& scene, double tooMuch) const;
  void indexByAxis();
  [[nodiscard]] std::size_t itemOf(int joint) const;
  [[nodiscard]] double enclosure(const SheetBearing& bearing) const;
  [[nodiscard]] double compactness(const Item& item, const Few<Tube>& tubes) const;
  [[nodiscard]] const std::vector<int>& linksOn(int axis) const {
    return m_on[static_cast<std::size_t>(axis)].links;
  }
  [[nodiscard]] const std::vector<Column>& columnsOn(int axis) const {
    return m_on[static_cast<std::size_t>(axis)].columns;
  }
  [[nodiscard]] static int shaftOn(const OnAxis& on, int link);
  void standUp();
  [[nodiscard]] Column armColumn(const SheetBearing& bearing) const;
  [[nodiscard]] Range rangeOf(int axis, int link) const;
  [[nodiscard]] double freeEndOf(const SheetBearing& bearing) const;
  [[nodiscard]] bool isOwn(int axis, int link) const;
  [[nodiscard]] Few<int> movedBy(const Item& item) const;
  [[nodiscard]] int conflictsOn(int axis, const Few<int>& moved) const;
  [[nodiscard]] Few<Tube> tubesTouchedBy(const Item& item) const;
  void listShafts(int axis) const;
  void keepInReach(Scene& scene, const Item& item, const std::vector<double>& candidates);
  [[nodiscard]] Extent boxOn(int axis, double low, double high, double from, double to) const;
  void addShafts(ShaftPlan& plan, int axis) const;

  const DrawnPart& m_part;
  const Placement& m_placement;
  SheetLayout& m_layout;
  std::vector<SheetBearing> m_bearings;
  std::vector<SheetCup> m_cups;
  std::vector<Item> m_items;
  std::vector<Piece> m_fixed;

  std::vector<OnAxis> m_on;
  /// What a link has on an axis; for conflictsOn(), which is asked too often to make room for it every time.
  struct OnShaft {
    Range range;
    double sum = 0;  ///< of the places of its columns
    int columns = 0;
    int cut = 0;      ///< of its columns, those in the way of a shaft
    int cutting = 0;  ///< of that shaft's columns, those in its way
  };
  mutable std::vector<OnShaft> m_shafts;
  /// By link: does it hold axes that are not parallel to its own? Its arms go round what is between.
  std::vector<bool> m_reachesAcross;
};

}  // namespace geargraph::inline schematic
