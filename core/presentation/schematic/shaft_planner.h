#pragma once

#include <optional>
#include <vector>

#include "core/presentation/schematic/drawn_train.h"
#include "core/presentation/schematic/shaft_plan.h"
#include "core/presentation/schematic/sheet_spacing.h"

namespace geargraph {

/// The algorithm of shaftPlan(): first the places of wheels, walls, bearings and arms in the arrangement
/// become slots of their parallel axes; then the slots get px, and shafts their extents.
class ShaftPlanner {
 public:
  ShaftPlanner(const DrawnPart& part, const DrawnTrain& train, SheetLayout& layout);
  ShaftPlan plan();

 private:
  /// A place along the parallel axes of a family.
  struct Spot {
    int axis = 0;
    double place = 0;   ///< along the family's first axis
    int rank = 0;       ///< order on the sheet of items at one place of the machine
    double wanted = 0;  ///< px
    std::optional<double> fixed;
    std::vector<SheetSpan> spans;
    double at = 0;  ///< px along the family's first axis, once found
  };
  /// Something on an axis that a link's shaft has to reach.
  struct Held {
    int axis = 0;
    int link = 0;
    std::size_t spot = 0;
    double before = 0;  ///< px by which the shaft extends before it
    double after = 0;
  };

  void findFamilies();
  void addWheels();
  void addRingCarriers();
  void layWalls();
  void addWalls();
  void addBearings();
  void addBearing(int joint);
  void addArm(const SheetBearing& bearing);
  void addPin(const PinPlan& pin, const SheetBearing& bearing);
  void addCrossShaftBoss(const CrossShaftBossPlan& boss, const SheetBearing& bearing);
  void separateArms();
  void spanBearings();
  void sortByPlace(std::vector<std::size_t>& spots, double tolerance);
  void solve();
  void takePlaces();
  void addShafts();

  std::size_t addSpot(int axis, double coordinate);
  /// Adds what a symbol at the spot occupies, from one height above its axis to another.
  void occupy(std::size_t spot, double before, double after, double from, double to);
  [[nodiscard]] double placeOf(int axis, double coordinate) const;
  [[nodiscard]] double placeOf(const SheetWheel& wheel) const { return m_spots[wheelSpot(wheel)].place; }
  [[nodiscard]] std::size_t wheelSpot(const SheetWheel& wheel) const {
    return m_wheelSpots[&wheel - m_layout.wheels.data()].at;
  }
  /// px along an axis of a placed spot on a parallel one.
  [[nodiscard]] double atOn(int axis, std::size_t spot) const;
  [[nodiscard]] double intersection(int axis, int other) const;
  [[nodiscard]] double hiddenPlace(SheetBearing& bearing);
  [[nodiscard]] const SheetWheel* wheelOnPin(const PinPlan& pin, int child) const;
  [[nodiscard]] double heightOf(const WallPlan& wall, double place, double radius) const;
  [[nodiscard]] std::optional<double> rimHeight(int axis, int link, double place, double radius) const;
  [[nodiscard]] double levelHeight(const WallPlan& wall, std::size_t number) const;
  [[nodiscard]] std::size_t shaftAt(int axis, int link, double place) const;
  [[nodiscard]] double laneHeight(int axis, int link, double place) const;
  [[nodiscard]] const SheetAxis& axis(int a) const { return m_layout.axes[a]; }
  [[nodiscard]] const AxisLayout& line(int a) const { return m_train.arrangement.axes[a]; }
  [[nodiscard]] const SheetAxis& first(int a) const { return axis(m_family[a]); }
  [[nodiscard]] bool isReversed(int a) const { return dot(axis(a).along, first(a).along) < 0; }
  [[nodiscard]] bool areParallel(int a, int b) const { return m_family[a] == m_family[b]; }
  [[nodiscard]] double tolerance(int a) const;

  static constexpr std::size_t kNoShaft = static_cast<std::size_t>(-1);

  const DrawnPart& m_part;
  const DrawnTrain& m_train;
  SheetLayout& m_layout;
  std::vector<int> m_depths;  ///< by shaft of the arrangement
  ByClass<int> m_family;      ///< the first one that is parallel on the sheet
  std::vector<Spot> m_spots;
  std::vector<Held> m_held;
  struct WheelSpots {
    std::size_t at = 0;
    std::size_t low = 0;
    std::size_t high = 0;
  };
  ByGear<WheelSpots> m_wheelSpots;
  std::vector<std::size_t> m_ringCarrierSpots;
  ByJoint<std::size_t> m_bearingSpots;
  std::vector<std::size_t> m_armSpots;
  struct WallSpots {
    std::size_t from = 0;
    std::size_t to = 0;
  };
  std::vector<WallSpots> m_wallSpots;
  std::vector<double> m_levels;  ///< by wall of the arrangement: height of an axial wall
  ShaftPlan m_plan;
};

}  // namespace geargraph
