#pragma once

#include <span>
#include <vector>

#include "core/machine/body_layout/axis_layout.h"
#include "core/machine/body_layout/profile_router.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A column of the grid: an interval along the axis. Gaps between wheels are divided into as many columns as
/// discs have room.
struct CoaxialColumn {
  double low = 0;
  double high = 0;
  int end = 0;   ///< -1 or 1: beyond all wheels on that side; 0: between them
  int rank = 0;  ///< of a column beyond the wheels: 0 is next to them
};

/// The planets on one axis class parallel to the central axis.
struct CoaxialPlanets {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal carrier = 0;  ///< link
  double distance = 0;
  std::vector<Interval> wheels;  ///< intervals along the central axis
};

/// The half plane through an axis with the wheels in it, as a problem for routeProfiles().
struct CoaxialSections {
  ProfileGrid grid;
  ByColumn<CoaxialColumn> columns;
  ByNet<ProfileNet> nets;
  ByNet<LinkOrdinal> linkOf;
  ByNet<std::vector<std::vector<std::size_t>>> planetsOf;  ///< by group: planets it carries
  std::vector<CoaxialPlanets> planets;
  ByGear<std::vector<NetOrdinal>> netsOfGear;  ///< one or none
  int innerRows = 0;       ///< number of rows for sleeves inside the wheels, from the axis outwards
  double innerRadius = 0;  ///< outer radius of these rows
  double cell = 0;         ///< height of the other rows
  double module = 1;

  [[nodiscard]] double rowLow(int row) const { return innerRadius + (row - innerRows) * cell; }
  [[nodiscard]] double rowMiddle(int row) const { return rowLow(row) + cell / 2; }
};

/// Half the height of a boss around a planet's pin, in modules.
constexpr double kPinBoss = 2.9;

/// `runOn`: links with one wheel may also turn on the shaft inside them, without extending to an end of the
/// axis.
[[nodiscard]] CoaxialSections coaxialSections(AxisGroupOrdinal axisGroup, SpanByClass<const AxisLayout> axes,
                                              const Placement& placement, const GearTrain& train, bool runOn);

/// The largest outer radius of shafts inside a wheel.
[[nodiscard]] double shaftRoom(const GearSpec& spec);

}  // namespace geargraph
