#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/kinds/hand.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Drives that are more than a pair of gears on parallel axes. The input is link 1 and turns at 1 rad/s, the
// output is the last link on the ground's axis. Each is an ordinary mechanism: links, joints and meshes that
// exist.

struct WormStage {
  int starts = 1;
  int teeth = 40;
  Hand hand = Hand::right;
};
/// Worm 1 and wheel 2: -1 or +1 times starts to teeth, by the hand. Rejected: teeth-geometry/worm.
[[nodiscard]] Expected<Mechanism> wormStage(const WormStage& stage);

/// Pinion 1 and face gear 2 on axes that meet at right angles. Rejected: teeth-geometry/ratio, unless the
/// face gear has more teeth.
[[nodiscard]] Expected<Mechanism> faceDrive(int pinionTeeth, int faceTeeth);

/// An axle: pinion 1 and gear 2 on axes that cross at right angles, at a distance of a fifth of the gear's
/// pitch diameter. Rejected: teeth-geometry/ratio, unless the gear has more teeth.
[[nodiscard]] Expected<Mechanism> hypoidAxle(int pinionTeeth, int gearTeeth);

struct BeltStage {
  int driver = 20;
  int driven = 40;
  Number pitch = Number(5);  ///< length of a tooth, in the document's unit
  bool crossed = false;
};
/// Pulleys 1 and 2 with a toothed belt, as far apart as three times the larger one's diameter.
[[nodiscard]] Expected<Mechanism> beltStage(const BeltStage& stage);

/// A strain wave drive: wave generator 1, flexspline 2 on its eccentric, cup 3 with the flexspline by pins;
/// the circular spline is the ground's. w_3 / w_1 = (flex - circular) / flex. Rejected: teeth-geometry,
/// unless the circular spline has more teeth.
[[nodiscard]] Expected<Mechanism> strainWave(int flexTeeth, int circularTeeth);

/// A cycloidal drive: crank 1, disc 2 of pins - 1 lobes, output 3 by pins; the ring of pins is the ground's.
/// w_3 / w_1 = -1 / (pins - 1). Rejected: teeth-geometry, of fewer than 4 pins.
[[nodiscard]] Expected<Mechanism> cycloidalDrive(int pins);

/// An RV reducer: sun 1, planet 2 on the output, which carries the eccentric 3 and the disc 4 of pins - 1
/// lobes; the output is link 5. w_1 / w_5 = 1 + planet / sun * pins. Rejected: as cycloidalDrive().
[[nodiscard]] Expected<Mechanism> rvReducer(int sunTeeth, int planetTeeth, int pins);

/// How the links on the ground turn for one turn of the only input, where the set as it stands decides that.
struct SetRatio {
  LinkOrdinal input = 0;
  LinkOrdinal output = 0;
  Rational speed = 0;  ///< w_output / w_input, with its sign
};
[[nodiscard]] std::optional<SetRatio> ratioOfSet(const Mechanism& set);

}  // namespace geargraph
