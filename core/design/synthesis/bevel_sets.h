#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// Case 1 with pinions between two equal side wheels 2 and 3: their speeds add up to twice the case's; places
/// left open. Refuses assembly where 2 side / pinions is not whole.
[[nodiscard]] Expected<Mechanism> bevelDifferentialSet(int sideTeeth, int pinionTeeth, int pinions);

/// Tooth counts of a wrist: what bends it, what turns the idler, and what the idler turns.
struct WristTeeth {
  int bendShaft = 20;
  int bend = 30;
  int rollShaft = 25;
  int idler = 40;
  int idlerPinion = 24;
  int tool = 18;
};

/// Housing 1, bend shaft 2, bend 3, roll shaft 4, idler 5 and tool 6 with module 2, axes through one point:
/// bend = -(bendShaft/bend)(q2 - q1), idler = (rollShaft/idler)(q4 - q1), tool = -(idlerPinion/tool)(idler -
/// bend).
[[nodiscard]] Mechanism bevelWrist(const WristTeeth& teeth);

}  // namespace geargraph::inline synthesis
