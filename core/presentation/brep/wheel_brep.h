#pragma once

#include "core/foundations/base/kind_table.h"
#include "core/machine/teeth/gear_spec.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/brep/brep.h"

namespace geargraph {

/// A wheel by its exact faces, in its own frame (gear_spec.h) and the unit of its lengths.
struct WheelBrep {
  Brep solid;
  double deviation =
      0;  ///< of its splines from the teeth, a length: bounded from above, at the sampled points
};

/// The solid of gearSolid() with planes, cylinders and cones where it has them; flanks, fillets, and all
/// surfaces of a throat are splines within `deviation` modules (of a worm: axial ones).
/// @pre specDiagnostics(spec) is empty, and so is noExactFaces(spec). Cost: O(teeth)
[[nodiscard]] WheelBrep wheelBrep(const GearSpec& spec, double deviation);

/// What CAD knows of a kind of wheel. `deviation` is a length.
struct WheelCad {
  WheelBrep (*make)(const GearSpec& spec, double deviation) = nullptr;
  /// Why this wheel has no exact faces, marked by toTranslate(), %1: its name; null, or empty: it has.
  const char* (*refuse)(const GearSpec& spec) = nullptr;
};

[[nodiscard]] KindTable<GearKind, WheelCad>& wheelCads();
/// WheelCad::refuse; empty: the wheel has exact faces.
[[nodiscard]] const char* noExactFaces(const GearSpec& spec);

class BrepBuilder;
/// The end planes of teeth on a cylinder, of which these are the outlines seen from above, and the body
/// below.
void addBodyBelow(BrepBuilder& builder, const GearSpec& spec, const std::vector<LoopEdge>& top,
                  const std::vector<LoopEdge>& bottom);

extern const WheelCad kTwistedCad;  ///< its section, turned along the axis
extern const WheelCad kConeCad;
extern const WheelCad kSmoothCad;
extern const WheelCad kThroatCad;
extern const WheelCad kConeBlankCad;  ///< a cone without teeth
extern const WheelCad kNoCad;         ///< none: teeth that are meshes only

}  // namespace geargraph
