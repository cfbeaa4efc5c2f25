#pragma once

#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/presentation/dxf/arc_fit.h"

namespace geargraph {

/// The finest and the usual deviation of profiles, modules.
constexpr double kFinestDeviation = 1e-5;
constexpr double kUsualDeviation = 5e-4;

/// The closed outline of the teeth of a wheel in its transverse plane, about its axis, counter-clockwise,
/// tooth 0 on +x: flanks, fillets, tip and root circles as arcs and lines within `deviation` (modules) of the
/// generated tooth. All teeth are the same but for their places. Lengths in the unit of the spec's module.
/// Cost: that of one tooth, and O(teeth). @pre isDrawnPlane(spec), specDiagnostics(spec) is empty
[[nodiscard]] std::vector<ArcVertex> toothOutline(const GearSpec& spec, double deviation);

/// Does the wheel have a transverse section with teeth? Not a bevel, nor one without teeth.
[[nodiscard]] bool isDrawnPlane(const GearSpec& spec);

}  // namespace geargraph
