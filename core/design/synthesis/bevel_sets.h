#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// A bevel differential: case 1 with pinions between two equal side gears 2 and 3, whose speeds sum to twice
/// the case's; places are left open. Rejects assembly if 2 side / pinions is not an integer.
[[nodiscard]] Expected<Mechanism> bevelDifferentialSet(int sideTeeth, int pinionTeeth, int pinions);

/// Tooth counts of a bevel wrist: the bend drive, the drive of the idler, and the pair from the idler to the
/// tool.
struct WristTeeth {
  int bendShaft = 20;
  int bend = 30;
  int rollShaft = 25;
  int idler = 40;
  int idlerPinion = 24;
  int tool = 18;
};

/// A bevel wrist: housing 1, bend shaft 2, bend 3, roll shaft 4, idler 5 and tool 6, module 2, axes through
/// one point: bend = -(bendShaft/bend)(q2 - q1), idler = (rollShaft/idler)(q4 - q1), tool =
/// -(idlerPinion/tool)(idler - bend).
[[nodiscard]] Mechanism bevelWrist(const WristTeeth& teeth);

}  // namespace geargraph
