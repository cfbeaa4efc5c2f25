#pragma once

#include <optional>
#include <stop_token>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/train/train_wheels.h"
#include "core/presentation/schematic/drawn_part.h"

namespace geargraph::inline bodies {
class DerivedGeometry;
}  // namespace geargraph::inline bodies

namespace geargraph::inline schematic {

/// What is drawn of a document's train: placement, wheels and arrangement in the positions of the part. They
/// are those of the whole train, as the 3D view shows it, without what the part leaves out.
struct DrawnTrain {
  Placement placement;
  TrainWheels wheels;
  Arrangement arrangement;  ///< axes with their bearings, arms, shafts, cups, walls, pins and tees
};

/// The part's share of the document's train; where the document's turning joints are no spanning tree, the
/// train of the part alone. std::nullopt if the part has no tree, or if cancelled. Cost:
/// DerivedGeometry::arrangement(), and linear in the train.
/// @pre the part is the document's
[[nodiscard]] std::optional<DrawnTrain> drawnTrain(const DrawnPart& part, const DerivedGeometry& document,
                                                   const std::stop_token& stop = {});

}  // namespace geargraph::inline schematic
