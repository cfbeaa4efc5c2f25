#pragma once

#include <span>
#include <vector>

#include "core/machine/arrangement/axis_layout.h"
#include "core/machine/arrangement/meridian_router.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline arrangement {

/// A stretch along the axis. Gaps between wheels are cut into as many as discs have room.
struct CoaxialColumn {
  double low = 0;
  double high = 0;
  int end = 0;   ///< beyond all wheels: -1 or 1 for the side, 0: between them
  int rank = 0;  ///< of an end: 0 is next to the wheels
};

/// A class of planets, on one axis parallel to the central one.
struct CoaxialPlanets {
  int axisClass = 0;
  int carrier = 0;  ///< link
  double distance = 0;
  std::vector<Stretch> wheels;  ///< on the central axis' line
};

/// The half plane about an axis with what stands in it, as a problem for routeMeridian().
struct CoaxialSections {
  MeridianGrid grid;
  std::vector<CoaxialColumn> columns;
  std::vector<MeridianNet> nets;
  std::vector<int> linkOf;                                       ///< by net
  std::vector<std::vector<std::vector<std::size_t>>> planetsOf;  ///< by net and group: planets it carries
  std::vector<CoaxialPlanets> planets;
  std::vector<std::vector<int>> netsOfGear;  ///< by gear of the train: nets (one or none)
  int innerRows = 0;                         ///< rows for sleeves within the wheels, numbered from the axis
  double innerRadius = 0;                    ///< of all of these
  double cell = 0;                           ///< height of the other rows
  double module = 1;

  [[nodiscard]] double rowLow(int row) const { return innerRadius + (row - innerRows) * cell; }
  [[nodiscard]] double rowMiddle(int row) const { return rowLow(row) + cell / 2; }
};

/// Half the height of an eye about a planet's pin, in modules.
constexpr double kPinEye = 2.9;

/// `runOn`: links with one wheel may also run on what is inside them, without coming out at an end.
[[nodiscard]] CoaxialSections coaxialSections(int axisClass, std::span<const AxisLayout> axes,
                                              const Placement& placement, const GearTrain& train, bool runOn);

/// Largest outer radius of shafts within a wheel.
[[nodiscard]] double shaftRoom(const GearSpec& spec);

}  // namespace geargraph::inline arrangement
