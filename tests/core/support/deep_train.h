#pragma once

#include <cstdint>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// A random train that is deep in space: each link turns on one of the four newest links, about an axis that
/// is parallel to its carrier's (two thirds) or meets it at a right angle, and meshes with a wheel that the
/// link below its carrier has on the carrier's axis. Pitch points are left open; three inputs, which are set.
/// Valid for any number of links from 4; the same seed gives the same train.
[[nodiscard]] Mechanism deepTrain(std::uint64_t seed, int links);

}  // namespace geargraph::test
