#pragma once

#include <optional>

#include "core/foundations/base/expected.h"
#include "core/foundations/exact/pi_number.h"
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

struct RackDrive {
  Number travel = Number(125);  ///< wanted, of a turn of the pinion, in the document's unit
  Number module = Number(2);    ///< of the rack, along its motion
};
constexpr int kFewestPinionTeeth = 6;
constexpr int kMostPinionTeeth = 400;
/// Pinion 1 and rack 2, which slides on the ground: the pinion with the whole number of teeth whose travel a
/// turn, teeth times pi times the module, is nearest to the wanted one. Rejected: schema, where the module or
/// the travel is not above 0; teeth-geometry, where the pinion would have fewer than kFewestPinionTeeth or
/// more than kMostPinionTeeth.
[[nodiscard]] Expected<Mechanism> rackDrive(const RackDrive& drive);

struct ScrewDrive {
  Number lead = Number(5);  ///< advance of a turn, in the document's unit
  Hand hand = Hand::right;
};
/// Screw 1 and nut 2, which slides on the ground: v_2 / w_1 is lead / (2 pi), against the screw's sense where
/// it is right-hand. Rejected: schema, where the lead is not above 0.
[[nodiscard]] Expected<Mechanism> screwDrive(const ScrewDrive& drive);

/// How the links on the ground move for one turn of the only input, where the set as it stands decides that.
struct SetRatio {
  LinkOrdinal input = 0;
  LinkOrdinal output = 0;
  PiNumber speed;       ///< of the output over that of the input, with its sign
  bool slides = false;  ///< of the output: its speed is a travel a radian, in the document's unit

  /// Turns of the output for one of the input, or its travel.
  [[nodiscard]] PiNumber ofTurn() const { return slides ? speed * PiNumber(2, 1) : speed; }
};
[[nodiscard]] std::optional<SetRatio> ratioOfSet(const Mechanism& set);

}  // namespace geargraph
