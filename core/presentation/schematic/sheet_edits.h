#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"
#include "core/presentation/schematic/sheet_frame.h"

namespace geargraph::inline schematic {

/// A shaft drawn on the sheet: a new link that turns about an axis.
struct DrawnShaft {
  SheetPoint from;
  SheetPoint to;
  LinkId carrier;    ///< what holds it; empty: what holds the axis already, else the ground
  double reach = 8;  ///< px: so near to an axis is on it
};

/// A new link with a turning joint on the axis that the shaft is drawn on, or on a new one where there is
/// none: level or upright as it is drawn, at a whole number of length units. The joint's offset is where the
/// middle of the shaft lies. The first axis of all goes through the origin.
///
/// An axis belongs to what holds it: a shaft that another link carries gets an axis of its own there.
/// Refuses unknown-id.
[[nodiscard]] Expected<Mechanism> withShaftOnSheet(Mechanism mechanism, const SheetFrame& frame,
                                                   const DrawnShaft& shaft);

/// Two links put into mesh on the sheet, from a place on one to a place on the other.
struct DrawnMesh {
  LinkId tail;
  LinkId head;
  SheetPoint from;
  SheetPoint to;
};

/// A gear mesh with teeth that fit the axes as they lie, at the document's module: the wheel that a link has
/// already keeps its teeth, two new wheels are equal. A drag that ends beyond the other's axis, seen from its
/// own, makes a ring about it; so does one that begins beyond. Axes that meet get a bevel pair. Two wheels
/// that are there already come together (withMeshSnapped).
/// Refuses self-joint and unknown-id.
[[nodiscard]] Expected<PlacedMechanism> withMeshOnSheet(Mechanism mechanism, const SheetFrame& frame,
                                                        const DrawnMesh& mesh);

/// An axis dragged across the sheet.
struct DraggedAxis {
  AxisId axis;
  SheetPoint from;
  SheetPoint to;
  bool snapped = true;  ///< the module to kModuleStep (axis_drag.h), a place to whole length units
};

/// The axis goes where it is dragged. With meshes it keeps its ray from the axis that it meshes with nearest
/// the ground, and the module follows its distance there (withAxisReach); the sheet shows those distances,
/// not places in space. One without goes there in space. Refuses unknown-id and what the fitting refuses.
[[nodiscard]] Expected<PlacedMechanism> withAxisOnSheet(const PlacedMechanism& before,
                                                        const SheetFrame& frame, const DraggedAxis& drag);

}  // namespace geargraph::inline schematic
