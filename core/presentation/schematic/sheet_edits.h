#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"
#include "core/presentation/schematic/sheet_frame.h"

namespace geargraph {

/// A shaft drawn on the sheet: a new link that turns about an axis.
struct DrawnShaft {
  CanvasPoint from;
  CanvasPoint to;
  LinkId carrier;  ///< the link that carries it; empty: the one that holds the axis already, else the ground
  double reach = 8;  ///< px: within this distance of an axis it is on the axis
};

/// A new link with a turning joint on the axis that the shaft is drawn on, or on a new one if there is none:
/// horizontal or vertical as drawn, at a whole number of length units. The joint's offset is that of the
/// middle of the shaft. The first axis of a document passes through the origin.
///
/// An axis belongs to the link that holds it: a shaft on another link gets an axis of its own there. Rejects
/// unknown-id.
[[nodiscard]] Expected<Mechanism> withShaftOnSheet(Mechanism mechanism, const CanvasFrame& frame,
                                                   const DrawnShaft& shaft);

/// A mesh drawn on the sheet, from a point on one link to a point on another.
struct DrawnMesh {
  LinkId tail;
  LinkId head;
  CanvasPoint from;
  CanvasPoint to;
};

/// Adds a gear mesh with teeth that fit the present axes at the document's module: an existing wheel keeps
/// its teeth, two new wheels are equal. A drag that begins or ends beyond the other link's axis makes that
/// wheel a ring gear. Intersecting axes get a bevel pair. Two existing wheels are brought together
/// (withMeshSnapped()). Rejects self-joint and unknown-id.
[[nodiscard]] Expected<PlacedMechanism> withMeshOnSheet(Mechanism mechanism, const CanvasFrame& frame,
                                                        const DrawnMesh& mesh);

/// An axis dragged across the sheet.
struct DraggedAxis {
  AxisId axis;
  CanvasPoint from;
  CanvasPoint to;
  bool snapped = true;  ///< the module to kModuleStep (axis_drag.h), a position to whole length units
};

/// Moves a dragged axis. An axis with meshes moves along its ray from the meshing axis nearest the ground,
/// and the module follows the distance (withAxisReach()), because the sheet shows those distances rather than
/// places in space. One without meshes moves in space. Rejects as the edits of fitting.
[[nodiscard]] Expected<PlacedMechanism> withAxisOnSheet(const PlacedMechanism& before,
                                                        const CanvasFrame& frame, const DraggedAxis& drag);

}  // namespace geargraph
