#pragma once

#include <optional>
#include <vector>

#include "core/machine/solids/shell_builder.h"
#include "core/machine/solids/web_windows.h"
#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// The profile of the body below the teeth, from the top face round to the bottom face, material on the left
/// (rings: on the right). It begins and ends on the planes (bevel: cones) of the faces. GearBody::plain: bore
/// or rim only. GearBody::dressed: hub, recessed web and rim where there is room for them.
[[nodiscard]] std::vector<ProfileVertex> bodyProfile(const GearSpec& spec);

/// Body and tips of the teeth together: a closed outline in the half plane through the axis, the two tips
/// last.
[[nodiscard]] std::vector<ProfileVertex> wheelOutline(const GearSpec& spec);

/// Openings in the web of a dressed wheel, where it is large enough to have them.
[[nodiscard]] std::optional<WebWindows> bodyWindows(const GearSpec& spec);

/// Outer diameter of a ring's rim: spec.rim, or if 0 enough for a stiff ring.
[[nodiscard]] double rimDiameter(const GearSpec& spec);

/// How far the wheel reaches from its axis: its rim, or its tips.
[[nodiscard]] double outerRadius(const GearSpec& spec);

/// The largest bore (diameter) that leaves 0.2 modules of material below the teeth.
[[nodiscard]] double largestBore(const GearSpec& spec);

/// The extent of the gear along its axis, in its own frame: lowest and highest z of teeth and body.
struct AxialSpan {
  double low = 0;
  double high = 0;
};
[[nodiscard]] AxialSpan axialSpan(const GearSpec& spec);
/// The same for the body alone, which a shaft has to fill: without the overhang of a bevel's teeth.
[[nodiscard]] AxialSpan hubSpan(const GearSpec& spec);

}  // namespace geargraph
