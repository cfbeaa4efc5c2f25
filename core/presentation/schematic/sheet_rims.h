#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph {

struct DrawnPart;
struct SheetLayout;

/// The pitch line of a toothed wheel on the sheet, on one side of its axis. A drag changes the tooth count.
struct SheetRim {
  LinkId link;
  std::vector<MeshId> meshes;  ///< of that wheel, at least one
  CanvasPoint from;            ///< ends of the line, px
  CanvasPoint to;
  CanvasPoint out;    ///< unit vector away from the axis
  double height = 0;  ///< px from the axis to the middle of the line, above 0
  friend bool operator==(const SheetRim&, const SheetRim&) = default;
};

[[nodiscard]] std::vector<SheetRim> sheetRims(const DrawnPart& part, const SheetLayout& layout);

/// The nearest rim of these links within `reach` px of a place; null if there is none.
[[nodiscard]] const SheetRim* rimNear(const std::vector<SheetRim>& rims, const std::vector<LinkId>& links,
                                      CanvasPoint place, double reach);

/// Tooth counts of the first mesh of a rim after a drag across the sheet.
struct DraggedTeeth {
  MeshId mesh;
  int tailTeeth = 1;
  int headTeeth = 1;
  int teeth = 1;  ///< of the dragged wheel: proportional to its height, rounded
  friend bool operator==(const DraggedTeeth&, const DraggedTeeth&) = default;
};
/// std::nullopt if the mechanism no longer has that mesh of the link.
[[nodiscard]] std::optional<DraggedTeeth> teethDragged(const Mechanism& mechanism, const SheetRim& rim,
                                                       CanvasPoint from, CanvasPoint to);

}  // namespace geargraph
