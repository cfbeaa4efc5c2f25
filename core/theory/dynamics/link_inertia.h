#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/machine/solids/mass_properties.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Where the mass of a link comes from.
enum class MassSource : std::uint8_t {
  none,    ///< no solid and no stated mass: massless
  solids,  ///< the link's wheels, shafts and arms at the document's density
  scaled,  ///< a stated mass, spread as the solids are
  stated,  ///< the document states mass and inertia, or there is no solid: then a point mass
};
/// "none", "solids", "scaled", "stated".
[[nodiscard]] const char* massSourceName(MassSource source);

/// A link as a rigid body: kg, m, kg m², in the reference pose, base frame.
struct LinkInertia {
  MassProperties body;
  MassSource source = MassSource::none;
};

/// The inertias of all links, by position. Solids are the wheels with their teeth and the bodies of the
/// train; where two parts of a link overlap (an arm and its shaft), the overlap counts twice. Attached 3D
/// files do not count. A stated mass without a centre is at the centre of the solids; without solids on the
/// link's axis.
///
/// The result is meaningless if `stop` was requested meanwhile. `metres`: in one of the document's unit.
/// Cost: O(triangles), about a millisecond per wheel.
/// @pre the train is the mechanism's, the placement has a tree
[[nodiscard]] std::vector<LinkInertia> linkInertias(const Mechanism& mechanism, const Placement& placement,
                                                    const GearTrain& train, double metres,
                                                    const std::stop_token& stop = {});

}  // namespace geargraph
