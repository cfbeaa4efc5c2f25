#pragma once

#include "core/mechanism/model/mechanism.h"

namespace geargraph::bench {

// Gear trains that grow without bound, for benchmarks; three inputs each where nothing else is said. All axes
// are parallel, so that peers without 3D geometry can read them too.

/// Carriers nested in each other: link k turns on link k-1, and gear k+1 meshes with link k-1 round carrier
/// k. The tree is as deep as it can be; cycles have length 2.
[[nodiscard]] Mechanism nestedCarriers(int links);

/// Two stacks of coaxial links, each turning on the one below it in the stack, and meshes across: the cycles
/// are as long as they can be.
[[nodiscard]] Mechanism coaxialStacks(int links);

/// Planetary stages behind one another, rings held, each carrier the next sun. One input; the symbolic
/// solution's expanded form explodes.
[[nodiscard]] Mechanism planetaryChain(int links);

/// A random epicyclic train: 3 links of each 100 and the carriers free, every other gear driven by a
/// neighbour on its carrier. Shallow, local, like real gearboxes of any size.
[[nodiscard]] Mechanism epicyclicTree(int links);

/// The same train with the program's choice of inputs written into it, as a user who drives it has.
[[nodiscard]] Mechanism driven(Mechanism train);
/// The same with valid inputs drawn at random: what was nearly triangular hangs together in blocks, and the
/// solution has more terms.
[[nodiscard]] Mechanism drivenAtRandom(Mechanism train);

/// epicyclicTree(), driven either way.
[[nodiscard]] Mechanism drivenTree(int links);
[[nodiscard]] Mechanism coupledTree(int links);

}  // namespace geargraph::bench
