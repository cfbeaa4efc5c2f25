#pragma once

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// The eight-speed automatic ZF 8HP70 from its published tooth counts 48/96, 48/96, 69/111, 23/85 (sun/ring).
/// Links: 1 input and second carrier, 2 output and fourth carrier, 3 first and second sun, 4 first ring,
/// 5 third ring and fourth sun, 6 first carrier and fourth ring, 7 third carrier, 8 third sun and second
/// ring, 9..12 the planets. Brakes A (3), B (4), clutches C (1, 5), D (7, 2), E (5, 7); states 1..8 and R.
[[nodiscard]] Mechanism eightSpeed();

/// Sun 1, ring 2 on bevel side wheels 1 and 2 of 16 teeth, carrier 3, pinion 4 of 10 on an axis across.
/// Couplings: clutch L (1, 3), clutch S (1, 2), brake P on the pinion, brake C on the carrier; no states.
[[nodiscard]] Mechanism bevelDifferential();

void addBrake(Mechanism& mechanism, const char* id, int link);
void addClutch(Mechanism& mechanism, const char* id, int link, int other);
void addState(Mechanism& mechanism, const char* name, const std::vector<const char*>& engaged, int drive,
              int driven);

}  // namespace geargraph::test
